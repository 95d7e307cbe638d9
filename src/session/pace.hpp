#pragma once

#include "session/run_view.hpp"

#include <chrono>
#include <cstdint>

namespace steplab {

/// Decides from the wall clock how many whole steps a playing run takes next, and measures how fast they go. It never
/// reads a clock itself: times are handed in.
class Pace {
public:
    using Time = std::chrono::steady_clock::time_point;
    using Duration = std::chrono::duration<double>;

    /// Playing begins or continues from here: what was missed before is not caught up.
    void begin(Time now);

    /// Steps to take now so that the run keeps to its rate, never more than fit into `slice` as measured so far.
    std::uint64_t steps_due(Time now, Rate rate, double dt, Duration slice) const;
    /// When the next step is due; `now` if it is already.
    Time next_due(Time now, Rate rate, double dt) const;

    /// `steps` were taken from `begin` to `end`, that is `simulated` seconds of the run. What a run that cannot keep up
    /// is behind by more than a tenth of a second is forgiven.
    void took(std::uint64_t steps, std::uint64_t evaluations, double simulated, Time begin, Time end, Rate rate);

    /// Steps and evaluations a second of computing; 0 before anything was measured.
    double steps_per_second() const { return seconds_ > 0 ? steps_ / seconds_ : 0; }
    double evaluations_per_second() const { return seconds_ > 0 ? evaluations_ / seconds_ : 0; }
    void forget_speed();

private:
    Time paid_until_{};  ///< wall-clock time up to which steps have been taken
    double steps_ = 0;   ///< measured, older measurements fading
    double evaluations_ = 0;
    double seconds_ = 0;
};

}  // namespace steplab
