#include "session/pace.hpp"

#include <algorithm>
#include <cmath>

namespace steplab {

namespace {

/// A run that cannot keep up is not made to catch up more than this.
constexpr Pace::Duration most_behind{0.1};
/// Measurements older than this fade, so that the read-out follows a change within moments.
constexpr double memory_seconds = 0.25;

Pace::Time::duration whole(Pace::Duration duration) {
    return std::chrono::duration_cast<Pace::Time::duration>(duration);
}

}  // namespace

void Pace::begin(Time now) { paid_until_ = now; }

std::uint64_t Pace::steps_due(Time now, Rate rate, double dt, Duration slice) const {
    const double fit = std::max(1.0, std::floor(steps_per_second() * slice.count()));
    if (rate.as_fast_as_possible) return static_cast<std::uint64_t>(fit);
    const double owed = std::floor(Duration(now - paid_until_).count() * rate.seconds_per_second / dt + 1e-9);
    return static_cast<std::uint64_t>(std::clamp(owed, 0.0, fit));
}

Pace::Time Pace::next_due(Time now, Rate rate, double dt) const {
    if (rate.as_fast_as_possible) return now;
    const Duration wait(std::min(dt / rate.seconds_per_second, 3600.0));
    return std::max(now, paid_until_ + whole(wait));
}

void Pace::took(std::uint64_t steps, std::uint64_t evaluations, double simulated, Time begin, Time end, Rate rate) {
    const Duration spent = end - begin;
    if (!rate.as_fast_as_possible) paid_until_ += whole(Duration(simulated / rate.seconds_per_second));
    if (rate.as_fast_as_possible || end - paid_until_ > most_behind)
        paid_until_ = std::max(paid_until_, end - whole(most_behind));
    const double fading = std::exp(-spent.count() / memory_seconds);
    steps_ = steps_ * fading + static_cast<double>(steps);
    evaluations_ = evaluations_ * fading + static_cast<double>(evaluations);
    seconds_ = seconds_ * fading + spent.count();
}

void Pace::forget_speed() { steps_ = evaluations_ = seconds_ = 0; }

}  // namespace steplab
