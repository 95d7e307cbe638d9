#pragma once

#include "core/elementwise.hpp"
#include "core/entry.hpp"
#include "core/field.hpp"
#include "core/interruption.hpp"
#include "core/lanes.hpp"
#include "core/number.hpp"
#include "methods/engines/accelerate.hpp"
#include "methods/engines/adaptive.hpp"
#include "methods/engines/collisions.hpp"
#include "methods/engines/compensated.hpp"
#include "methods/engines/encounters.hpp"
#include "methods/engines/integrator.hpp"
#include "methods/engines/own_steps.hpp"
#include "methods/engines/step_control.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <type_traits>
#include <utility>

namespace steplab {

/// Positions, velocities and accelerations (drag included) of one time, with what rounding has cut off the first two.
template <class T>
struct Moment {
    Field<T> x, v, a;
    Lost<T> lost;

    Moment() = default;
    explicit Moment(std::size_t count) : x(count), v(count), a(count), lost(true, count) {}
};

/// A compensated sum from one moment into the next, a register at a time.
template <class T>
class SumInto {
public:
    SumInto(const Field<T>& from, const Field<T>& lost, Field<T>& to, Field<T>& left)
        : from_(from.flat().data()), lost_(lost.flat().data()), to_(to.flat().data()), left_(left.flat().data()) {}

    /// The sum at place k, which is stored.
    Lanes<T> add(std::size_t k, Lanes<T> increment) const {
        Lanes<T> sum = Lanes<T>::load(from_ + k), lost = Lanes<T>::load(lost_ + k);
        add_compensated(sum, lost, increment);
        sum.store(to_ + k);
        lost.store(left_ + k);
        return sum;
    }

private:
    const T *from_, *lost_;
    T *to_, *left_;
};

/// Runs a method that chooses its own steps, from frame to frame. A step may reach beyond the frame: what is between
/// its ends is computed for output only. The times of frames are their number times dt, the time of the steps is a
/// compensated sum. `Rule` does one step:
///     static constexpr ControlConstants control
///     explicit Rule(std::size_t count)
///     double attempt(System&, const Moment& from, T h, Moment& next, T tolerance)   fills next.x, next.v, next.lost;
///     the
///                                                                                   error relative to the tolerance
///     void finish(System&, T h, Moment& next)                                       fills next.a
///     void between(Uncounted&, const Moment& from, const Moment& next, T h, T part, State<T>& out)   at from + part h
///     double work(Uncounted&, const Moment& from, const Moment& next, T h, T part, const CountedDrag&)
///         the work of drag up to from + part h; of rules that have a type CanCountDrag
///     void forget()                                                                 scratch is no longer of the last
///     step
template <class T, class Rule>
class AdaptiveSteps {
public:
    static constexpr bool counts_drag = requires { typename Rule::CanCountDrag; };
    static constexpr IntegratorCapabilities capabilities{
        .progress = true, .stops = true, .collisions = true, .drag_work = counts_drag};

    explicit AdaptiveSteps(const ParameterValues& values)
        : tolerance_(std::max(static_cast<T>(values[tolerance_parameter.name]),
                              T(2) * std::numeric_limits<T>::epsilon())),  // no precision holds more
          control_(Rule::control),
          guard_(tolerance_) {}

    template <class System>
    void start(System& system, const State<T>& state) {
        const std::size_t count = state.displacement.count();
        rule_ = Rule(count);
        from_ = Moment<T>(count);
        next_ = Moment<T>(count);
        next_.x = state.displacement;
        next_.v = state.velocity;
        accelerate(system, next_.x, next_.v, next_.a);
        progress_ = {};
        guard_.state({});
        system.hold(next_.x, next_.v);
        tolerance_here_ = tolerance_in(system, tolerance_);
        control_.length(first_length(system));
    }

    template <class System>
    void step(System& system) {
        ++progress_.frames;
        take_steps_to(system, frame_time(system));
    }

    template <class System>
    void synchronised(const System& system, State<T>& out) const {
        state_at(system, frame_time(system), out);
    }

    /// Times have the digits of double at least.
    using Time = std::conditional_t<std::is_same_v<T, float>, double, T>;

    /// Steps until one ends at this time since the start or after it: what step() does where no frames are counted.
    template <class System>
    void take_steps_to(System& system, Time target) {
        while (progress_.time - target + progress_.lost < 0) inner_step(system, target);
    }

    CountedDrag& counted_drag() requires counts_drag { return drag_; }
    const CountedDrag& counted_drag() const requires counts_drag { return drag_; }
    template <class System>
    double drag_work(const System& system) const requires counts_drag {
        return drag_.sum().value() + work_in_last_step(system, before_end(frame_time(system)));
    }

    /// At a time in the last step.
    template <class System>
    void state_at(const System& system, Time time, State<T>& out) const {
        const T before_end = this->before_end(time);
        if (!(before_end > T(0))) {
            out.displacement = next_.x;
            out.velocity = next_.v;
        } else if (progress_.across > T(0)) {
            within_crossing(from_, next_, progress_.across, progress_.length - before_end, out);
        } else {
            system.hold(from_.x, from_.v);
            Uncounted<System> uncounted(system);
            rule_.between(uncounted, from_, next_, progress_.length, (progress_.length - before_end) / progress_.length,
                          out);
        }
    }

    template <class Self, class F>
    static void each_part(Self& self, F f) {
        const auto moment = [&](auto& m) { f(m.x), f(m.v), f(m.a), f(m.lost.x), f(m.lost.v); };
        moment(self.from_);
        moment(self.next_);
    }

    const CollisionRecord& collisions() const { return guard_.record(); }
    std::optional<OwnStop> stopped() const { return progress_.stop; }

    /// What of the internal state is no field: plain data.
    struct Progress {
        std::uint64_t frames = 0;
        Time time = 0, lost = 0;  ///< of the end of the last step, and what rounding has cut off it
        T length = T(0);          ///< of the last step
        T across = T(0);          ///< if it went across a collision: the time from its beginning to there
        std::optional<OwnStop> stop;
        StepWatch<Time> watch;
        bool crossed = false;  ///< at its end other pairs act (encounters.hpp)
        typename StepControl<T>::State control{};
        typename CollisionGuard<T>::State guard{};
    };

    Progress progress() const {
        Progress now = guard_.saved_in(progress_);
        now.control = control_.state();
        return now;
    }
    void progress(const Progress& progress) {
        progress_ = progress;
        control_.state(progress.control);
        guard_.state(progress.guard);
        rule_.forget();
    }

private:
    template <class System>
    Time frame_time(const System& system) const {
        return static_cast<Time>(progress_.frames) * static_cast<Time>(system.dt());
    }

    /// How long before the end of the last step.
    T before_end(Time time) const { return static_cast<T>(progress_.time - time + progress_.lost); }

    /// The work of drag from its beginning on.
    template <class System>
    double work_in_last_step(const System& system, T before_end) const {
        if (!(progress_.length > T(0))) return 0;  // none was taken
        const T part = before_end > T(0) ? (progress_.length - before_end) / progress_.length : T(1);
        if (progress_.across > T(0))
            return work_in_crossing(drag_, from_, next_, to_double(progress_.across),
                                    to_double(progress_.length) * to_double(part));
        system.hold(from_.x, from_.v);
        Uncounted<System> uncounted(system);
        return rule_.work(uncounted, from_, next_, progress_.length, part, drag_);
    }

    /// One step of the method from next_, which becomes from_.
    template <class System>
    void inner_step(System& system, Time target) {
        check_interruption();
        if constexpr (counts_drag) {
            if (drag_.on()) drag_.add(work_in_last_step(system, T(0)));
        }
        std::swap(from_, next_);
        system.hold(from_.x, from_.v);
        if (progress_.crossed) accelerate(system, from_.x, from_.v, from_.a);
        // behind a crossing the force is another one, of which no step has told anything yet
        const T caution = progress_.crossed ? T(8) : T(1);
        const T longest = longest_step(system, motion(from_), caution * control_.length(), tolerance_) / caution;
        if (longest < control_.length()) {
            control_.length(longest);
            if (!(longest > shortest_step(target))) return stop(system, longest, target);
        }
        const T wanted = guard_.behind(control_.length());
        T h = guard_.before(system, from_, wanted, static_cast<double>(progress_.time));
        while (!guard_.at_hand()) {
            const double error = rule_.attempt(system, from_, h, next_, tolerance_here_);
            if (std::isfinite(error) && guard_.passes(system, from_, next_.x, h)) continue;
            if (error <= 1) {
                rule_.finish(system, h, next_);
                if (crossing(system, motion(from_), motion(next_), h) != Crosses::no) continue;
                take(system, h, error);
                const bool still = progress_.watch.stands_still(progress_.time, static_cast<Time>(system.dt()));
                return still ? stop(system, h, target) : void();
            }
            if (!(h > shortest_step(target))) return stop(system, h, target);
            control_.rejected(error, h);
            h = control_.length();
        }
        cross_collision(system);
    }

    T shortest_step(Time target) const { return static_cast<T>(target * std::numeric_limits<Time>::epsilon()); }

    /// No step is short enough, or the motion is lost.
    template <class System>
    void stop(const System& system, T h, Time target) {
        progress_.stop = own_stop(system, from_.x, static_cast<double>(progress_.time), h);
        std::fill(next_.x.flat().begin(), next_.x.flat().end(), std::numeric_limits<T>::quiet_NaN());
        progress_.time = target;
        progress_.lost = 0;  // else the clock may stand before the frame for ever
    }

    template <class System>
    void take(System& system, T h, double error) {
        progress_.crossed = system.hold(next_.x, next_.v);
        if (!(h < control_.length())) control_.accepted(error);  // a step cut short says nothing about longer ones
        progress_.length = h;
        progress_.across = T(0);
        add_compensated(progress_.time, progress_.lost, static_cast<Time>(h));
    }

    static MotionOf<T> motion(const Moment<T>& moment) { return {moment.x, moment.v, moment.a}; }

    template <class System>
    void cross_collision(System& system) {
        control_.length(guard_.scale());
        progress_.across = guard_.cross(system, from_, next_, static_cast<double>(progress_.time));
        progress_.length = T(2) * progress_.across;
        progress_.crossed = system.hold(next_.x, next_.v);
        std::swap(next_.lost, from_.lost);
        add_compensated(progress_.time, progress_.lost, static_cast<Time>(progress_.length));
        rule_.forget();
    }

    /// Norms of a pair of fields as the first step's choice takes them: root of the sum over all components, each
    /// relative to tolerance (1 + |y|) of the state.
    double norm(const Field<T>& of_x, const Field<T>& of_v) {
        const auto square_into = [&](const Field<T>& value, const Field<T>& state, Field<T>& out) {
            const T *const y = value.flat().data(), *const s = state.flat().data();
            T* const square = out.flat().data();
            elementwise(out.flat().size(), [=, tolerance = tolerance_](std::size_t k) {
                const T scaled = y[k] / (tolerance * (T(1) + std::abs(s[k])));
                square[k] = scaled * scaled;
            });
        };
        square_into(of_x, next_.x, from_.x);
        square_into(of_v, next_.v, from_.v);
        return std::sqrt(static_cast<double>(sum_of(from_.x)) + static_cast<double>(sum_of(from_.v)));
    }

    /// The first step's length from the sizes of the state, its slope and its second derivative, the last from a step
    /// of Euler's method (Hairer, Norsett, Wanner I, II.4, algorithm on p. 169).
    template <class System>
    T first_length(System& system) {
        const double size = norm(next_.x, next_.v), slope = norm(next_.v, next_.a);
        const double small = size > 1e-5 && slope > 1e-5 ? 0.01 * size / slope : 1e-6;
        const double curvature = change_of_slope(system, static_cast<T>(small)) / small;
        const double fastest = std::max(slope, curvature);
        const double length = fastest > 1e-15 ? power(0.01 / fastest, 1 / Rule::control.order) : 1e-3 * small;
        from_ = next_;
        return static_cast<T>(std::min(100 * small, fastest > 1e-15 ? length : std::max(1e-6, length)));
    }

    template <class System>
    double change_of_slope(System& system, T h) {
        Moment<T> trial = next_;
        T *const x = trial.x.flat().data(), *const v = trial.v.flat().data(), *const a = trial.a.flat().data();
        const T *const v0 = next_.v.flat().data(), *const a0 = next_.a.flat().data();
        elementwise(trial.x.flat().size(), [=](std::size_t k) {
            x[k] += h * v0[k];
            v[k] += h * a0[k];
        });
        accelerate(system, trial.x, trial.v, trial.a);
        elementwise(trial.x.flat().size(), [=](std::size_t k) {
            v[k] -= v0[k];
            a[k] -= a0[k];
        });
        return norm(trial.v, trial.a);
    }

    T tolerance_;
    T tolerance_here_ = tolerance_;  ///< in this scene
    StepControl<T> control_;
    CollisionGuard<T> guard_;
    mutable Rule rule_{0};   ///< scratch
    Moment<T> from_, next_;  ///< the ends of the last step
    Progress progress_;
    CountedDrag drag_;  ///< up to the beginning of the last step
};

}  // namespace steplab
