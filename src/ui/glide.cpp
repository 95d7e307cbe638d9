#include "ui/glide.hpp"

#include <algorithm>
#include <utility>

namespace steplab::ui {

namespace {

/// Steps that follow each other faster look smooth by themselves; slower ones are meant to be seen one by one.
constexpr double shortest = 0.02, longest = 0.5;
/// Beyond this many particles, making the moments in between costs more than it shows.
constexpr std::size_t most_particles = 20000;

/// Seconds from one step of a playing run to the next; 0 where there is nothing to glide over.
double pause_between(const RunView& a, const RunView& b) {
    const bool follow = a.playing && b.playing && a.run == b.run && b.frame.step > a.frame.step;
    const bool fits = a.frame.positions.size() == b.frame.positions.size() &&
                      b.frame.positions.size() + b.frame.ensemble.size() <= most_particles;
    if (!follow || !fits || b.rate.as_fast_as_possible || b.segment_start > a.frame.time) return 0;
    const double seconds = (b.frame.time - a.frame.time) / b.rate.seconds_per_second;
    return seconds >= shortest && seconds <= longest ? seconds : 0;
}

}  // namespace

void Glide::arrived(std::shared_ptr<const RunView> view, Time now) {
    from_ = std::exchange(newest_, std::move(view));
    begin_ = now;
    duration_ = from_ ? pause_between(*from_, *newest_) : 0;
}

double Glide::fraction(Time now) const {
    if (duration_ == 0) return 1;
    return std::clamp(std::chrono::duration<double>(now - begin_).count() / duration_, 0.0, 1.0);
}

}  // namespace steplab::ui
