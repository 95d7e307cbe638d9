#pragma once

#include "core/coupling.hpp"
#include "core/elementwise.hpp"
#include "core/field.hpp"
#include "core/interruption.hpp"
#include "methods/engines/accelerate.hpp"
#include "methods/engines/adaptive.hpp"
#include "methods/engines/collisions.hpp"
#include "methods/engines/compensated.hpp"
#include "methods/engines/encounters.hpp"
#include "methods/engines/foreseen.hpp"
#include "methods/engines/integrator.hpp"
#include "methods/engines/own_steps.hpp"
#include "methods/engines/series_forces.hpp"
#include "methods/engines/series_motion.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

namespace steplab {

/// The motion as a power series in time, used as far as it converges to the tolerance. A series up to t^K needs the
/// accelerations in K - 1 orders and counts as K - 1 evaluations.
struct Taylor {
    static constexpr ParameterInfo parameters[] = {tolerance_parameter};

    static double bytes_of_interactions(const Coupling&, const Interactions& all) { return 1500 * all.pairs; }
    static std::optional<std::string> refusal(const Coupling& coupling) {
        constexpr std::size_t most_near = Coupling::most_held, most_pairs = 2000;
        const std::string not_for = " particles, not for " + std::to_string(coupling.particles);
        if (coupling.cut && coupling.particles > most_near)
            return "a power series ends whenever a pair crosses the cut-off, which is practical for up to " +
                   std::to_string(most_near) + not_for;
        if (coupling.kind == Coupling::Kind::all && coupling.particles > most_pairs)
            return "it stores the power series of all pairs, which is possible for up to " +
                   std::to_string(most_pairs) + not_for;
        if (!coupling.smooth) return "its potential has min, max or abs, whose seams a power series does not see";
        return std::nullopt;
    }

    static constexpr MethodInfo info{
        .id = "taylor",
        .name = "Taylor series",
        .what =
            "Chooses step size and order from the tolerance; between two steps the motion is as accurate as at the "
            "steps.",
        .order = 20,
        .order_with_drag = 20,
        .evaluations = 19,
        .linear_limit = infinity,
        .adaptive = true,
        .conserves = "all invariants, within the tolerance",
        .source = "Jorba, Zou, Experimental Mathematics 14 (2005) 99",
        .parameters = parameters,
        .refusal = refusal,
        .bytes_of_interactions = bytes_of_interactions,
    };

    template <class T>
    class Integrator;
};

/// Coefficient k of a displacement is stored as x_k unit^k, unit being a power of two near the step: exact, in range.
template <class T>
class Taylor::Integrator : public CountsDrag {
    /// Times have at least double precision.
    using Time = std::conditional_t<std::is_same_v<T, float>, double, T>;

public:
    static constexpr IntegratorCapabilities capabilities{
        .progress = true, .stops = true, .collisions = true, .drag_work = true};

    explicit Integrator(const ParameterValues& values)
        : tolerance_(std::clamp(values[tolerance_parameter.name],
                                2 * static_cast<double>(std::numeric_limits<T>::epsilon()), 0.1)),
          log_tolerance_(logarithm(tolerance_)),
          last_(best_order(log_tolerance_)),
          guard_(static_cast<T>(values[tolerance_parameter.name])) {}

    template <class System>
    void start(System& system, const State<T>& state) {
        x_.assign(last_ + 1, Field<T>(state.displacement.count()));
        lost_ = Lost<T>(true, state.displacement.count());
        a_ = end_ = Field<T>(state.displacement.count());
        x_[0] = state.displacement;
        v_ = state.velocity;
        log_tolerance_ = logarithm(series_tolerance_in(system, tolerance_));
        forces_ = series_forces(system.force(), state, last_ - 1);
        progress_ = {.unit = power_of_two_below(system.dt())};
        guard_.state({});
        expand(system);
    }

    template <class System>
    void step(System& system) {
        ++progress_.frames;
        const Time target = frame_time(system);
        while (target - progress_.begin - progress_.begin_lost > static_cast<Time>(progress_.length)) {
            check_interruption();
            if (drag_.on()) drag_.add(work_in_series(system, progress_.length));
            advance(system);
            expand(system);
            // below this time nothing moves by more than rounding
            lengthen(
                time_of_rounding(std::span<const Field<T>>(x_), progress_.unit, progress_.length, forces_->axes()));
            if (is_stuck(target, system.dt())) return stop(system, target);
        }
    }

    template <class System>
    void synchronised(const System& system, State<T>& out) const {
        const T since = since_begin(system);
        if (progress_.across > T(0) && since > progress_.across) {
            Field<T> a(v_.count());
            return within_crossing(now(a), behind_collision(system), progress_.across, since, out);
        }
        out.displacement = x_[0];
        out.velocity = v_;
        T *const x = out.displacement.flat().data(), *const v = out.velocity.flat().data();
        each_change(since, [=](std::size_t p, N change_of_x, N change_of_v) {
            (N::load(x + p) + change_of_x).store(x + p);
            (N::load(v + p) + change_of_v).store(v + p);
        });
    }

    template <class System>
    double drag_work(const System& system) const {
        return drag_.sum().value() + work_in_series(system, since_begin(system));
    }

    template <class Self, class F>
    static void each_part(Self& self, F f) {
        for (auto& coefficient : self.x_) f(coefficient);
        f(self.v_);
        f(self.lost_.x);
        f(self.lost_.v);
    }

    /// The part of the internal state that is not a field: plain data.
    struct Progress {
        std::uint64_t frames = 0;
        Time begin = 0, begin_lost = 0;  ///< time at which the series begins, and its rounding error
        T length = T(0);                 ///< duration of the series
        T across = T(0);                 ///< time from its beginning to a collision within it, else 0
        T unit = T(1);
        std::optional<OwnStop> stop = {};
        int stuck = 0;  ///< series in a row that ended at once
        StepWatch<Time> watch = {};
        typename CollisionGuard<T>::State guard{};
    };
    Progress progress() const { return guard_.saved_in(progress_); }
    void progress(const Progress& progress) {
        progress_ = progress;
        guard_.state(progress.guard);
    }

    const CollisionRecord& collisions() const { return guard_.record(); }
    std::optional<OwnStop> stopped() const { return progress_.stop; }

private:
    using N = Lanes<T>;

    /// A series may end at once or not exist, but not one after the other.
    bool is_stuck(Time target, T dt) {
        const T least = static_cast<T>(target * (4 * std::numeric_limits<Time>::epsilon()));
        progress_.stuck = progress_.length > least && !forces_->singular() ? 0 : progress_.stuck + 1;
        lengthen(least);
        return progress_.watch.stands_still(progress_.begin, static_cast<Time>(dt)) || progress_.stuck > 100;
    }

    template <class System>
    void stop(const System& system, Time target) {
        progress_.stop = own_stop(system, x_[0], static_cast<double>(progress_.begin), progress_.length);
        progress_.begin = target;
        std::fill(v_.flat().begin(), v_.flat().end(), std::numeric_limits<T>::quiet_NaN());
    }

    void lengthen(T least) {
        if (!(progress_.length > least)) set_length(least);
    }

    template <class System>
    T since_begin(const System& system) const {
        return static_cast<T>(frame_time(system) - progress_.begin - progress_.begin_lost);
    }
    template <class System>
    Time frame_time(const System& system) const {
        return static_cast<Time>(progress_.frames) * static_cast<Time>(system.dt());
    }

    /// Advances to the end of the series, where the next one begins.
    template <class System>
    void advance(System& system) {
        if (progress_.across > T(0)) {
            Motion<T> behind(v_.count());
            guard_.cross(system, now(a_), behind, static_cast<double>(progress_.begin));
            x_[0] = behind.x;
            v_ = behind.v;
        } else {
            move_to_end();
        }
        add_compensated(progress_.begin, progress_.begin_lost, static_cast<Time>(progress_.length));
    }

    void move_to_end() {
        T *const x = x_[0].flat().data(), *const v = v_.flat().data();
        T *const lost_x = lost_.x.flat().data(), *const lost_v = lost_.v.flat().data();
        each_change(progress_.length, [=](std::size_t p, N change_of_x, N change_of_v) {
            add_compensated_at(x + p, lost_x + p, change_of_x);
            add_compensated_at(v + p, lost_v + p, change_of_v);
        });
    }

    template <class F>
    void each_change(T t, F f) const {
        each_series_sum(std::span<const Field<T>>(x_), progress_.unit, t, forces_->axes(), f);
    }

    /// The series of the motion from x_[0] and v_, in a unit of time that suits its duration.
    template <class System>
    void expand(System& system) {
        system.hold(x_[0], v_);
        T too_small = T(0), too_large = std::numeric_limits<T>::infinity();
        for (int attempt = 0; attempt < 40; ++attempt) {
            compute_series(system);
            const T share = reach();
            // in too small a unit all coefficients underflow, and the series seems to end
            const bool ends = share >= longest_series<T> && progress_.unit < system.dt() / longest_series<T>;
            const bool fits = share > T(1) / T(64) && share < T(64) && !ends;
            progress_.length = progress_.unit * (std::isfinite(share) ? share : T(1) / T(4096));
            if (fits || forces_->singular()) break;
            (share >= T(1) && std::isfinite(share) ? too_small : too_large) = progress_.unit;
            progress_.unit = unit_between(too_small, progress_.length, too_large);
        }
        progress_.length = longest_step(system, now(a_), progress_.length, static_cast<T>(tolerance_));
        if (!system.held().empty())
            progress_.length =
                length_until_crossing(system, v_.count(), progress_.length, [this](T t, Motion<T>& then) {
                    series_motion(std::span<const Field<T>>(x_), v_, progress_.unit, t, forces_->axes(), then);
                });
        progress_.length = foreseen_length<T>(system, x_, v_, progress_.unit, forces_->axes(), progress_.length,
                                              static_cast<T>(tolerance_));
        if (!forces_->singular()) end_at_collision(system);
    }

    /// When a collision approaches, the series ends before it; close to the collision it ends as far behind it. A
    /// series does not reach far beyond a distance of zero: collisions are predicted at several times its duration.
    template <class System>
    void end_at_collision(System& system) {
        const MotionOf<T> begin = now(a_);
        T length = guard_.before(system, begin, progress_.length, static_cast<double>(progress_.begin));
        if (!guard_.approaching()) {
            T ahead = foresight * progress_.length;
            foresee(begin, ahead, end_);
            if (any_pass(system, x_[0], end_) && guard_.passes(system, begin, end_, ahead))
                length = std::min(length, ahead);
        }
        set_length(length);
        while (guard_.approaching()) {
            if (guard_.at_hand()) return reach_across();
            series_displacements(std::span<const Field<T>>(x_), progress_.unit, progress_.length, forces_->axes(),
                                 end_);
            if (!guard_.passes(system, begin, end_, length)) return;
            set_length(length);
        }
    }
    static constexpr T foresight = T(4);

    void set_length(T length) {
        progress_.length = length;
        progress_.across = T(0);
    }

    void reach_across() {
        set_length(T(2) * guard_.time());
        progress_.across = guard_.time();
    }

    /// The motion at the beginning of the series; its accelerations, drag included, are written to `a`.
    MotionOf<T> now(Field<T>& a) const {
        const T of_x = T(2) / (progress_.unit * progress_.unit);
        const T* const second = x_[2].flat().data();
        T* const out = a.flat().data();
        elementwise(a.flat().size(), [=](std::size_t p) { out[p] = of_x * second[p]; });
        return {x_[0], v_, a};
    }

    /// As long behind the collision as the beginning of the series is before it.
    template <class System>
    Motion<T> behind_collision(const System& system) const {
        Field<T> a(v_.count());
        Motion<T> behind(v_.count());
        system.hold(x_[0], v_);
        Uncounted<System> uncounted(system);
        go_across(uncounted, now(a), progress_.across, behind);
        return behind;
    }

    /// The work of drag so long since the beginning of the series.
    template <class System>
    double work_in_series(const System& system, T since) const {
        const bool behind = progress_.across > T(0) && since > progress_.across;
        const double work =
            series_work(drag_, std::span<const Field<T>>(x_), progress_.unit, behind ? progress_.across : since);
        if (!behind) return work;
        const double across = to_double(progress_.across);
        return work + work_at_even_slope(drag_, behind_collision(system), -across, to_double(since) - 2 * across);
    }

    T reach() const {
        if (forces_->singular()) return square_root(std::numeric_limits<T>::epsilon());
        return series_reach(std::span<const Field<T>>(x_), v_, progress_.unit, log_tolerance_, forces_->axes());
    }

    /// All coefficients, order by order: (k + 1) (k + 2) x_(k+2) = a_k - gamma (k + 1) x_(k+1).
    template <class System>
    void compute_series(System& system) {
        forces_->find_interactions(x_[0], v_);
        const T* const velocity = v_.flat().data();
        T* const first = x_[1].flat().data();
        elementwise(v_.flat().size(), [=, unit = progress_.unit](std::size_t p) { first[p] = unit * velocity[p]; });
        for (std::size_t k = 0; k + 2 <= last_; ++k) {
            forces_->accelerations(x_[k], k, a_);
            next_order(a_, k, progress_.unit, system.drag(), forces_->axes(), x_);
        }
        system.count_evaluations(last_ - 1);
    }

    double tolerance_, log_tolerance_;  ///< the latter in this scene
    std::size_t last_;                  ///< order of the last coefficient, K
    std::vector<Field<T>> x_;           ///< coefficients of the displacements
    Field<T> v_;                        ///< velocities at the beginning of the series
    Lost<T> lost_;
    Progress progress_;
    CollisionGuard<T> guard_;
    Field<T> a_, end_;
    std::unique_ptr<SeriesForces<T>> forces_;
};

}  // namespace steplab
