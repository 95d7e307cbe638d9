#pragma once

#include "core/elementwise.hpp"
#include "core/field.hpp"
#include "core/number.hpp"
#include "methods/engines/compensated.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <type_traits>

// What methods share that choose their own steps by the time scale of the motion.

namespace steplab {

/// Where the end of an adaptive method's last inner step lies, relative to the frame that is to be shown, in two parts:
/// it keeps its digits however many frames and steps there were.
template <class T>
class InnerTime {
public:
    using Time = std::conditional_t<std::is_same_v<T, float>, double, T>;

    void next_frame(T dt) {
        ++frames_;
        add_compensated(ahead_, lost_, -static_cast<Time>(dt));
    }
    void inner_step(T h) { add_compensated(ahead_, lost_, static_cast<Time>(h)); }
    /// How far the end of the last inner step is after the frame; below zero while another step is needed.
    Time ahead() const { return ahead_ + lost_; }
    /// The same, relative to the start of the segment.
    double since_start(T dt) const {
        return static_cast<double>(frames_) * static_cast<double>(dt) + static_cast<double>(ahead());
    }

private:
    std::uint64_t frames_ = 0;
    Time ahead_ = 0, lost_ = 0;
};

/// The first step, that of the time scale of the motion. Where next to nothing acts yet that is longer than what the
/// run is asked for by powers of ten, and what lies within it could not be told from its ends: steps grow from frames
/// on.
template <class T>
T first_step(T of_motion, T dt) {
    constexpr T most_frames = std::is_same_v<T, float> ? T(1024) : T(131072);  // their times keep half of the digits
    return std::min(of_motion, most_frames * dt);
}

/// 1 / omega along the motion from x, v, where the accelerations are a: omega^2 = |change of a| / |change of x| over a
/// small time, found again with that time itself; not longer than drag takes. dt where nothing changes.
template <class System, class T>
T time_scale(System& system, const Field<T>& x, const Field<T>& v, const Field<T>& a) {
    Field<T> later_x = x, later_a(x.count());
    const T longest = first_step(std::numeric_limits<T>::max(), system.dt());
    T scale = system.dt(), after = scale / T(1024);
    for (int i = 0; i < 3; ++i) {
        elementwise(x.flat().size(), [&](std::size_t k) {
            later_x.flat()[k] = x.flat()[k] + after * (v.flat()[k] + after / T(2) * a.flat()[k]);
        });
        system.accelerations(later_x, later_a);
        T moved = T(0), changed = T(0);
        for (std::size_t k = 0; k < x.flat().size(); ++k) {
            const T dx = later_x.flat()[k] - x.flat()[k], da = later_a.flat()[k] - a.flat()[k];
            moved += dx * dx;
            changed += da * da;
        }
        const bool lost = !std::isfinite(changed);  // in a wall, of which nothing was felt before
        if (!(changed > T(0)) || !(moved > T(0)) || (lost && after <= longest)) break;
        scale = after = lost ? longest : square_root(square_root(moved / changed));
    }
    return system.drag() > T(0) ? std::min(scale, T(1) / system.drag()) : scale;
}

/// Where rounding is as steep as the force, steps shrink until time hardly goes on. Plain data.
template <class Time>
struct StepWatch {
    std::uint32_t steps = 0;  ///< since
    Time from = 0;            ///< this time

    /// Asked after each step, with the time at its end: at the rate of the last ones a frame would take more than 1e14
    /// steps.
    bool stands_still(Time now, Time dt) {
        if (++steps < steps_watched) return false;
        const Time gone = now - from;
        steps = 0;
        from = now;
        return gone < Time(1e-9) * dt;
    }

private:
    static constexpr std::uint32_t steps_watched = 131072;
};

/// The tolerance that a precision can keep.
template <class T>
T kept_tolerance(T tolerance) {
    return std::max(tolerance, T(64) * std::numeric_limits<T>::epsilon());
}

/// Square of the accelerations that move nothing in a step of length h: by less than the error allowed, absolute and
/// relative. `x` is the sum of the squares of all displacements. A scene at rest, whose accelerations are
/// rounding alone, so does not shorten the steps.
template <class T>
T idle_accelerations(T error, T x, T h) {
    const T smallest = error / (h * h);
    return smallest * smallest * (T(1) + x);
}

/// What to multiply a step with whose motion has covered the phase z, so that the next one covers `aim`.
template <class T>
T step_factor(T aim, T z) {
    return std::clamp(aim / z, T(0.25), T(4));
}
/// A step after which the factor is smaller than this has an error some thirty times too large: it is taken again.
inline constexpr double smallest_accepted_factor = 0.8;

/// How far a polynomial of the last step, of this length, is carried on to guess a step of length h. After steps cut
/// short before a collision the guess is of what is near.
template <class T>
T guess_ratio(T h, T last) {
    return std::min(h / last, T(4));
}

}  // namespace steplab
