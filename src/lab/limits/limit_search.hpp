#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>

namespace steplab {

/// Whether a vibration grows in so many steps of dt.
struct GrowthQuestion {
    double dt = 0;
    std::uint64_t steps = 0;
    double allowed = 0.1;  ///< of a bounded vibration: ModeRun::grows
    std::optional<bool> grows{};

    bool same(const GrowthQuestion& other) const {
        return dt == other.dt && steps == other.steps && allowed == other.allowed;
    }
};

/// Where to look for the dt from which on a vibration grows, by bisection to 3e-5.
struct LimitSearch {
    double expected;      ///< by theory; 0 and infinity too
    double above;         ///< a dt just above it at which growth is seen soonest, 0: none
    double time_scale;    ///< of the vibration
    std::uint64_t steps;  ///< of a run

    /// 0: it grows at any dt, infinity: at none.
    double limit(const std::function<bool(const GrowthQuestion&)>& grows) const;

    /// The same number, found with fewer calls: each answers up to `most` questions, the first one at least. They are
    /// those that the search is likeliest to ask next if theory is about right.
    double limit(std::size_t most, const std::function<void(std::span<GrowthQuestion>)>& answer) const;
};

}  // namespace steplab
