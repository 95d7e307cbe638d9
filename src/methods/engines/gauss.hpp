#pragma once

#include "core/entry.hpp"
#include "core/interruption.hpp"
#include "core/root.hpp"
#include "methods/engines/accelerate.hpp"
#include "methods/engines/collisions.hpp"
#include "methods/engines/encounters.hpp"
#include "methods/engines/foreseen.hpp"
#include "methods/engines/gauss_stages.hpp"
#include "methods/engines/integrator.hpp"
#include "methods/engines/moving_axes.hpp"
#include "methods/engines/own_steps.hpp"
#include "methods/engines/step_control.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>

namespace steplab {

/// IRKGL16: the Gauss method of order 16 in steps of dt, or, if `tolerance` is not 0, in steps that it chooses.
///
/// Steps of dt: where the iteration does not converge a step is taken in two, four, ... equal pieces.
///
/// Own steps: the forces of a step are a polynomial in Legendre's form; if they vary as cos(omega t), its coefficient
/// k is at most (2 k + 1) j_k(z) ~ z^k / (2 k - 1)!! of them, z = omega h / 2. The last two coefficients of all
/// particles together so give omega, and the error of order 16 is kept by keeping z at a size that goes with the 16th
/// root of the tolerance. Collisions are detected and crossed (collisions.hpp); steps of dt go through them blindly.
template <class T>
class Gauss : public CountsDrag {
public:
    static constexpr IntegratorCapabilities capabilities{
        .progress = true, .stops = true, .collisions = true, .drag_work = true};

    explicit Gauss(const ParameterValues& values)
        : tolerance_(values["tolerance"] > 0 ? kept_tolerance(static_cast<T>(values["tolerance"])) : T(0)),
          guard_(tolerance_) {}

    template <class System>
    void start(System& system, const State<T>& state) {
        end_ = TwoPartState<T>(state);
        begin_ = end_;
        progress_ = {};
        progress_.axes = moving_axes(system.force(), state);
        stages_ = stages(state.displacement.count());
        known_ = GaussStages<T>::room_for_known(state.displacement);
        progress_.last = progress_.next = system.dt();
        guard_.state({});
        begin_a_ = Field<T>(end_.x.count());
        aim_ = std::min(T(longest), T(reach) * root(tolerance_in(system, tolerance_), 16));
        if (tolerance_ > T(0)) system.hold(end_.x, end_.v);
        system.accelerations(end_.x, begin_a_);
        guess(begin_a_);
        if (tolerance_ > T(0))
            progress_.next = first_step(T(2) * aim_ * time_scale(system, end_.x, end_.v, begin_a_), system.dt());
    }

    template <class System>
    void step(System& system) {
        if (tolerance_ == T(0)) return step_of_dt(system);
        progress_.time.next_frame(system.dt());
        while (progress_.time.ahead() < 0) own_step(system);
    }

    /// Between the ends of an own step: a shorter step from its beginning, of full order.
    template <class System>
    void synchronised(const System& system, State<T>& out) const {
        const T ahead = static_cast<T>(progress_.time.ahead());
        if (ahead > T(0) && progress_.across > T(0)) return synchronised_at_collision(system, ahead, out);
        TwoPartState<T> seen = ahead > T(0) ? begin_ : end_;
        if (ahead > T(0)) solved_inside(system, progress_.last - ahead).advance(seen, seen);
        out = {seen.x, seen.v};
    }

    template <class System>
    double drag_work(const System& system) const {
        if (tolerance_ == T(0)) return drag_.sum().value();
        return drag_.sum().value() + work_in_own_step(system, static_cast<T>(progress_.time.ahead()));
    }

    const CollisionRecord& collisions() const { return guard_.record(); }
    std::optional<OwnStop> stopped() const { return progress_.stop; }

    template <class Self, class F>
    static void each_part(Self& self, F f) {
        TwoPartState<T>::each_part(self.end_, f);
        f(self.known_);
        if (self.tolerance_ > T(0)) TwoPartState<T>::each_part(self.begin_, f);
    }

    struct Progress {
        T last = T(0);    ///< length of the last step, to which the known forces belong
        T next = T(0);    ///< of the next own step
        T across = T(0);  ///< if the last one went across a collision: the time from its beginning to there
        std::optional<OwnStop> stop;
        int halvings = 0;  ///< a step of dt is taken in 2^halvings pieces
        std::size_t axes = 3;
        InnerTime<T> time;  ///< of own steps
        typename CollisionGuard<T>::State guard{};
    };
    Progress progress() const { return guard_.saved_in(progress_); }
    void progress(const Progress& saved) {
        progress_ = saved;
        guard_.state(saved.guard);
        stages_ = stages(end_.x.count());
    }

private:
    GaussStages<T> stages(std::size_t particles) const {
        return GaussStages<T>(particles, progress_.axes, iteration_error());
    }

    static constexpr int most_halvings = 30, most_refused = 40;
    /// Fewer iterations than this: pieces twice as long are tried next time.
    static constexpr std::size_t easy = 10;
    /// omega h / 2 at tolerance 1, and the longest that the iteration and the estimate are good for.
    static constexpr double reach = 4.6, longest = 2.9;

    /// Of the stages, relative: well below rounding, as what the iteration leaves has the same sign in all steps and
    /// its sum would show; well below the error allowed.
    T iteration_error() const {
        return std::max(std::numeric_limits<T>::epsilon() / T(1024), tolerance_ * T(iteration_share));
    }
    static constexpr double iteration_share = 1e-3;

    template <class System>
    void step_of_dt(System& system) {
        std::uint64_t pieces = std::uint64_t{1} << progress_.halvings;
        std::size_t iterations = 0;
        for (std::uint64_t i = 0; i < pieces;) {
            check_interruption();
            const T h = system.dt() / static_cast<T>(pieces);
            if (take(system, h)) {
                iterations = std::max(iterations, stages_.iterations());
                ++i;
            } else if (progress_.halvings == most_halvings) {
                return stop(system, end_, static_cast<double>(i) * static_cast<double>(h), h);
            } else {
                ++progress_.halvings;
                pieces *= 2;
                i *= 2;
            }
        }
        if (progress_.halvings > 0 && iterations < easy) --progress_.halvings;
    }

    /// One step of length h, unless its iteration does not converge.
    template <class System>
    bool take(System& system, T h) {
        if (!stages_.solve(system, end_, h, {known_, T(1), h / progress_.last})) return false;
        accept(h);
        if (drag_.on()) drag_.add(gauss_work(drag_, stages_.matrices(), end_, known_, h));
        stages_.advance(end_, end_);
        return true;
    }

    void accept(T h) {
        stages_.keep(known_);
        progress_.last = h;
    }

    /// A step of length h from begin_, to within the last own step.
    template <class System>
    GaussStages<T> solved_inside(const System& system, T h) const {
        System copy = system;
        if (tolerance_ > T(0)) copy.hold(begin_.x, begin_.v);
        GaussStages<T> inside = stages(begin_.x.count());
        inside.solve(copy, begin_, h, {known_, T(0), h / progress_.last});
        return inside;
    }

    /// The work of drag in the last own step up to a time before its end.
    template <class System>
    double work_in_own_step(const System& system, T ahead) const {
        if (!(now(system) > 0)) return 0;  // none was taken
        if (progress_.across > T(0)) {
            const T since = T(2) * progress_.across - std::max(ahead, T(0));
            return at_collision(system, [&](const MotionOf<T>& before, const MotionOf<T>& after) {
                return work_in_crossing(drag_, before, after, to_double(progress_.across), to_double(since));
            });
        }
        if (!(ahead > T(0)))
            return gauss_work(drag_, GaussMatrices(static_cast<long double>(system.drag() * progress_.last)), begin_,
                              known_, progress_.last);
        const T h = progress_.last - ahead;
        const GaussStages<T> inside = solved_inside(system, h);
        Field<T> forces = GaussStages<T>::room_for_known(begin_.x);
        inside.keep(forces);
        return gauss_work(drag_, inside.matrices(), begin_, forces, h);
    }

    /// From end_, which becomes begin_.
    template <class System>
    void own_step(System& system) {
        check_interruption();
        if (drag_.on()) drag_.add(work_in_own_step(system, T(0)));
        std::swap(begin_, end_);
        system.hold(begin_.x, begin_.v);
        const bool hidden = has_hidden_forces(system);
        if (hidden) beginning(system);
        progress_.next = longest_step(system, beginning_known(), progress_.next, tolerance_);
        T h = progress_.next;
        guard_.begin_step();
        if (guard_.approaching()) {
            h = guard_.before(system, beginning(system), h, now(system));
            if (!guard_.approaching()) progress_.next = h;
        }
        const bool possible = progress_.next > T(0);
        for (int refused = 0; possible && refused < most_refused; ++refused) {
            if (guard_.at_hand()) return cross_collision(system);
            const bool solved = stages_.solve(system, begin_, h, {known_, T(1), guess_ratio(h, progress_.last)});
            stages_.advance(begin_, end_);
            if (straddles(system, h)) continue;
            if (solved && fits(h)) {
                if (crosses(system, h)) continue;
                if (!hidden || is_foreseen(system, beginning_known(), stages_, end_.x, tolerance_ / h)) {
                    accept(h);
                    progress_.across = T(0);
                    return progress_.time.inner_step(h);
                }
                progress_.next = h / T(4);
            }
            if (!solved) progress_.next = h / T(2);
            h = progress_.next;
        }
        stop(system, begin_, now(system), h);
        progress_.time.inner_step(system.dt());
    }

    /// True if the trial step is good; if not, or if another length is better, the next one has it. A step cut short
    /// says nothing about longer ones.
    bool fits(T h) {
        const T factor = step_factor(aim_, phase(stages_.spectrum(), h));
        const bool refused = factor < T(smallest_accepted_factor);
        const bool other = factor < T(0.94) || factor > T(1.06);  // an equal step is cheaper
        if (refused || (other && !(h < progress_.next))) progress_.next = h * factor;
        return !refused;
    }

    template <class System>
    bool straddles(System& system, T& h) {
        return any_pass(system, begin_.x, end_.x) && std::isfinite(sum_of(end_.x)) &&
               guard_.passes(system, beginning(system), end_.x, h);
    }

    template <class System>
    bool crosses(System& system, T& h) {
        if (system.held().empty()) return false;
        return crosses_on_the_way(system, beginning(system), end_.x, end_.v, h);
    }

    template <class System>
    void cross_collision(System& system) {
        Motion<T> behind(begin_.x.count());
        const T length = guard_.scale();
        progress_.across = guard_.cross(system, beginning(system), behind, now(system));
        end_.x = behind.x;
        end_.v = behind.v;
        end_.lost = begin_.lost;
        guess(behind.a);
        progress_.last = progress_.next = length;
        progress_.time.inner_step(T(2) * progress_.across);
    }

    template <class System>
    void synchronised_at_collision(const System& system, T ahead, State<T>& out) const {
        at_collision(system, [&](const MotionOf<T>& before, const MotionOf<T>& after) {
            within_crossing(before, after, progress_.across, T(2) * progress_.across - ahead, out);
        });
    }

    /// Calls f with both ends of the step across a collision.
    template <class System, class F>
    auto at_collision(const System& system, F f) const {
        system.hold(begin_.x, begin_.v);
        Uncounted<System> uncounted(system);
        Field<T> a(end_.x.count()), end_a(end_.x.count());
        accelerate(uncounted, begin_.x, begin_.v, a);
        accelerate(uncounted, end_.x, end_.v, end_a);
        return f(MotionOf<T>{begin_.x, begin_.v, a}, MotionOf<T>{end_.x, end_.v, end_a});
    }

    template <class System>
    MotionOf<T> beginning(System& system) {
        accelerate(system, begin_.x, begin_.v, begin_a_);
        return beginning_known();
    }
    MotionOf<T> beginning_known() const { return {begin_.x, begin_.v, begin_a_}; }

    template <class System>
    double now(const System& system) const {
        return progress_.time.since_start(system.dt());
    }

    /// Forces that do not change are the first guess where nothing is known of theirs.
    void guess(const Field<T>& a) {
        each_coordinate(
            a, [&](std::size_t k) { std::fill_n(known_.flat().data() + stage_count * k, stage_count, a.flat()[k]); });
    }

    /// z = omega h / 2 of the fastest motion.
    T phase(const typename GaussStages<T>::Spectrum& spectrum, T h) const {
        constexpr T factor_6 = 10395, factor_7 = 135135;  // 11!!, 13!!
        constexpr T smallest = T(1) / T(64);
        T x = T(0);
        each_coordinate(end_.x, progress_.axes, [&](std::size_t k) { x += end_.x.flat()[k] * end_.x.flat()[k]; });
        const T error = std::max(tolerance_, T(1024) * std::numeric_limits<T>::epsilon());
        const T forces = spectrum.force + idle_accelerations(error, x, h);
        const T part_6 = factor_6 * factor_6 * (spectrum.coefficient_6 / forces);
        const T part_7 = factor_7 * factor_7 * (spectrum.coefficient_7 / forces);
        if (!(part_6 + part_7 > T(0))) return smallest;
        return std::max({smallest, square_root(square_root(root(part_6, 3))), square_root(root(part_7, 7))});
    }

    /// No step is short enough: never silently wrong.
    template <class System>
    void stop(const System& system, const TwoPartState<T>& at, double time, T h) {
        progress_.stop = own_stop(system, at.x, time, h);
        std::fill(end_.x.flat().begin(), end_.x.flat().end(), std::numeric_limits<T>::quiet_NaN());
    }

    T tolerance_;
    T aim_ = T(0);           ///< what z is kept at
    TwoPartState<T> end_;    ///< of the last step
    TwoPartState<T> begin_;  ///< of the last own step
    Field<T> known_;         ///< forces at the stages of the last step
    Field<T> begin_a_;       ///< accelerations at the beginning of an own step, where asked for
    CollisionGuard<T> guard_;
    Progress progress_;
    GaussStages<T> stages_;
};

}  // namespace steplab
