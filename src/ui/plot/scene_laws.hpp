#pragma once

#include "sim/run/pair_law.hpp"
#include "sim/run/run_description.hpp"

#include <optional>
#include <vector>

namespace steplab::ui {

/// What plots show of a scene besides its run, computed once for each scene.
class SceneLaws {
public:
    /// Frequencies of the normal modes of a scene of few particles (mode_frequencies()).
    const std::optional<std::vector<double>>& modes(const RunDescription& description);
    const std::vector<PairLaw>& pairs(const RunDescription& description);

    /// Scenes of more particles have no modes here: they would take longer than a frame of the window.
    static constexpr std::size_t most_particles = 64;

private:
    void follow(const RunDescription& description);

    std::optional<RunDescription> of_;
    bool modes_known_ = false, pairs_known_ = false;
    std::optional<std::vector<double>> modes_;
    std::vector<PairLaw> pairs_;
};

}  // namespace steplab::ui
