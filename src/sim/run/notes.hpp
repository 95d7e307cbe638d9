#pragma once

#include "sim/run/simulation.hpp"

#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

namespace steplab {

/// What rounding does to a run that goes on all the same, one sentence each; none as a rule: steps so short that they
/// add less than rounding keeps of it, displacements so large that they no longer resolve the scene's bonds, and
/// tolerances that the precision does not hold.
/// `farthest`: largest displacement from the reference positions, in metres. `rate`: of the motion, in 1/s, asked for
/// with that which is enough where no frequency of the scene is known; 0 or null: not known, either.
std::vector<std::string> notes_of_rounding(const RunDescription& run, double farthest,
                                           const std::function<double(double)>& rate = nullptr);
/// Those of a run where it stands. One that diverged has a reason instead.
std::vector<std::string> notes_of_rounding(const Simulation& simulation);

/// Those of many runs: each kind of note once, with how many runs have it and the words of the first.
class NotesOfRuns {
public:
    /// The next run, and its `farthest` at the end.
    void add(const RunDescription& run, double farthest);
    /// A run that diverged has none.
    void add_diverged() { ++runs_; }
    std::vector<std::string> all() const;

    /// What one run has of each kind.
    using ByKind = std::array<std::optional<std::string>, 3>;

private:
    struct Kind {
        std::size_t runs = 0, first = 0;
        std::string text;
    };
    std::size_t runs_ = 0;
    std::array<Kind, std::tuple_size_v<ByKind>> kinds_;
};

}  // namespace steplab
