#pragma once

#include "session/run_view.hpp"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace steplab {

/// A place on the time line.
struct Mark {
    std::uint64_t step = 0;
    double time = 0;
    std::string text;
    friend bool operator==(const Mark&, const Mark&) = default;
};

/// What is known of the time line of a session.
struct TimeLineView {
    std::uint64_t reached = 0;  ///< the last step that the leading run was at
    double reached_time = 0;
    std::vector<Mark> changes = {};  ///< what was done, the start left out
    std::vector<Mark> bookmarks = {};
    /// Ways that were left: where they leave the present one, and how far they go.
    struct Branch {
        double from = 0, to = 0;
        friend bool operator==(const Branch&, const Branch&) = default;
    };
    std::vector<Branch> branches = {};
    bool can_undo = false, can_redo = false;
};

/// What the interface sees of a session: one consistent moment of all its runs. Plain data.
struct SessionView {
    RunView leading = {};
    std::vector<RunView> followers = {};  ///< at the same time, by the rule of step_at()
    TimeLineView line = {};
};

}  // namespace steplab
