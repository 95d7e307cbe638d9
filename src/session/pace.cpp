#include "session/pace.hpp"

#include "core/clamped.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace steplab {

namespace {

/// A run that cannot keep up is not made to catch up more than this.
constexpr std::chrono::milliseconds most_behind{100};
/// Measurements older than this fade, so that the read-out follows a change within moments.
constexpr double memory_seconds = 0.25;

/// Longer than anybody waits for the next step [s].
constexpr double longest = 1e8;

}  // namespace

void Pace::begin(Time now) { paid_until_ = now; }

std::uint64_t Pace::steps_due(Time now, Rate rate, double dt, Duration slice) const {
    constexpr std::uint64_t most = 1'000'000'000'000'000;
    const auto fit = clamped_floor<std::uint64_t>(steps_per_second() * slice.count(), 1, most);
    if (rate.as_fast_as_possible) return fit;
    const double owed = Duration(now - paid_until_).count() * rate.seconds_per_second / dt + 1e-9;
    return clamped_floor<std::uint64_t>(owed, 0, fit);
}

Pace::Time Pace::next_due(Time now, Rate rate, double dt) const {
    if (rate.as_fast_as_possible) return now;
    return std::max(now, paid_until_ + clamped_seconds(dt / rate.seconds_per_second, 3600));
}

void Pace::took(std::uint64_t steps, std::uint64_t evaluations, double simulated, Time begin, Time end, Rate rate) {
    const Duration spent = end - begin;
    if (!rate.as_fast_as_possible) {
        const auto paid = clamped_seconds(simulated / rate.seconds_per_second, longest);
        paid_until_ = std::min(paid_until_, end + clamped_seconds(longest, longest)) + paid;
    }
    paid_until_ = std::max(paid_until_, end - most_behind);
    const double fading = std::exp(-spent.count() / memory_seconds);
    steps_ = steps_ * fading + static_cast<double>(steps);
    evaluations_ = evaluations_ * fading + static_cast<double>(evaluations);
    seconds_ = seconds_ * fading + spent.count();
}

void Pace::forget_speed() { steps_ = evaluations_ = seconds_ = 0; }

}  // namespace steplab
