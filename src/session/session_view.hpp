#pragma once

#include "lab/limits/blow_up.hpp"
#include "lab/limits/present_limit.hpp"
#include "lab/study/cost_scan.hpp"
#include "session/compared.hpp"
#include "session/error_samples.hpp"
#include "session/run_view.hpp"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
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
    bool backwards = false;  ///< the session plays that way
    struct Loop {
        double from = 0, to = 0;  ///< times of its steps
        friend bool operator==(const Loop&, const Loop&) = default;
    };
    std::optional<Loop> loop = {};
};

/// How far the runs of a session are from the motion of their scene at one time.
struct SessionErrors {
    double time = 0;                                 ///< of the leading run
    std::vector<std::optional<Compared>> runs = {};  ///< the leading one first; none of one that is over
    bool exact = false;                              ///< against the closed form
    std::string how = {};                            ///< the reference of the leading run, in words
};

/// What accuracy costs on the scene of a session: the points of a scan so far.
struct CostsView {
    double time = 0;  ///< over which all runs go [s]
    std::vector<CostPoint> points = {};
    std::vector<std::optional<CostPoint>> runs = {};  ///< those of the session, the leading one first; none: diverged
    double done = 0;                                  ///< the fraction of the series that are complete
    bool complete = false;
    bool provisional = false;  ///< errors are against a quick reference, until there is a better one
    std::string how = {};      ///< the reference in words, or why nothing is known
};

/// What is known of a trajectory file that is played in place of a session.
struct PlaybackView {
    std::string file = {};
    std::uint64_t frame = 0;   ///< that is shown, counted from 0
    std::uint64_t frames = 1;  ///< all that can be read
    std::string fault = {};    ///< why there are no more; empty if the file is whole
    /// The file holds all particles of its scene: energies and forces are known, and it can be continued.
    bool measured = true;
    bool has_velocities = true;
    double looked_through = 1;  ///< the part of the file in which frames were looked for so far
    std::string units = {};     ///< of its numbers, where they are said to be others than steplab's
};

/// A recorded session that is played like a film.
struct FilmView {
    double done = 0;  ///< the part of its steps
    friend bool operator==(const FilmView&, const FilmView&) = default;
};

/// What the interface sees of a session: one consistent moment of all its runs. Plain data.
struct SessionView {
    RunView leading = {};
    std::vector<RunView> followers = {};  ///< at the same time, by the rule of step_at()
    TimeLineView line = {};
    bool equal_cost = false;
    std::string not_equal = {};  ///< why one of them does not have the cost of the leading run; empty: all have
    std::optional<SessionErrors> errors = {};     ///< if they are wanted; of this moment, or of one before it
    std::vector<ErrorSeries> error_series = {};   ///< of each run, as far as it was compared at the steps of a grid
    std::shared_ptr<const CostsView> costs = {};  ///< if they are wanted and known
    /// How the steps of the leading run stand to its scene at this moment, or one before; null: not known.
    std::shared_ptr<const PresentLimit> present = {};
    std::shared_ptr<const BlowUp> blow_up = {};  ///< why it diverged, as far as that is known
    std::optional<PlaybackView> playback = {};   ///< if a trajectory is played
    std::optional<FilmView> film = {};           ///< while a recorded session is played, but for a part of a lesson
};

}  // namespace steplab
