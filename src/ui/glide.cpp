#include "ui/glide.hpp"

#include <algorithm>
#include <utility>

namespace steplab::ui {

namespace {

/// Seconds from step to step: faster ones are smooth without interpolation, slower ones are watched one by one.
constexpr double shortest = 0.02, longest = 0.5;
/// With more particles, interpolation costs more than it is worth.
constexpr std::size_t most_particles = 20000;

/// Seconds from one step of a playing run to the next; 0 if there is nothing to interpolate.
double pause_between(const RunView& a, const RunView& b) {
    const bool follow = a.playing && b.playing && a.run == b.run && b.frame.step > a.frame.step;
    const bool fits = a.frame.positions.size() == b.frame.positions.size() &&
                      b.frame.positions.size() + b.frame.ensemble.size() <= most_particles;
    if (!follow || !fits || b.rate.as_fast_as_possible || b.smooth_since > a.frame.time) return 0;
    const double seconds = (b.frame.time - a.frame.time) / b.rate.seconds_per_second;
    return seconds >= shortest && seconds <= longest ? seconds : 0;
}

}  // namespace

void Glide::arrived(std::shared_ptr<const SessionView> view, Time now) {
    from_ = std::exchange(newest_, std::move(view));
    begin_ = now;
    duration_ = from_ ? pause_between(from_->leading, newest_->leading) : 0;
}

double Glide::fraction(Time now) const {
    if (duration_ == 0) return 1;
    return std::clamp(std::chrono::duration<double>(now - begin_).count() / duration_, 0.0, 1.0);
}

}  // namespace steplab::ui
