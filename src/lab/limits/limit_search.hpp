#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>

namespace steplab {

/// The question whether a vibration grows in a number of steps of dt.
struct GrowthQuestion {
    double dt = 0;
    std::uint64_t steps = 0;
    double allowed = 0.1;  ///< variation of a bounded vibration: ModeRun::grows
    std::optional<bool> grows{};

    bool same(const GrowthQuestion& other) const {
        return dt == other.dt && steps == other.steps && allowed == other.allowed;
    }
};

/// A search for the smallest dt at which a vibration grows, by bisection to 3e-5.
struct LimitSearch {
    double expected;                    ///< by theory, including 0 and infinity
    double above;                       ///< a dt just above it at which growth is detected soonest; 0: none
    double time_scale;                  ///< of the vibration
    std::uint64_t steps;                ///< of a run
    std::uint64_t steps_beyond = 1024;  ///< of a run far beyond the limits of explicit methods

    /// The limit. 0: it grows at any dt; infinity: at none.
    double limit(const std::function<bool(const GrowthQuestion&)>& grows) const;

    /// The same number, found with fewer calls: each answers up to `most` questions, at least the first one. They are
    /// the most likely next questions of the search if theory is approximately right.
    double limit(std::size_t most, const std::function<void(std::span<GrowthQuestion>)>& answer) const;
};

}  // namespace steplab
