#pragma once

#include "core/elementwise.hpp"
#include "core/entry.hpp"
#include "core/interruption.hpp"
#include "core/root.hpp"
#include "methods/engines/accelerate.hpp"
#include "methods/engines/adaptive.hpp"
#include "methods/engines/collisions.hpp"
#include "methods/engines/encounters.hpp"
#include "methods/engines/foreseen.hpp"
#include "methods/engines/gauss_stages.hpp"
#include "methods/engines/integrator.hpp"
#include "methods/engines/own_steps.hpp"
#include "methods/engines/radau.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>

namespace steplab {

/// Gauss-Radau of order 15 with the steps chosen for the scene as a whole: the fastest motion in it, seen in the last
/// coefficients of all accelerations together, covers a phase omega h that goes with the 15th root of the tolerance, so
/// that errors are in proportion to it.
template <class T, class Control = RadauControl>
class GaussRadau : public CountsDrag {
public:
    static constexpr IntegratorCapabilities capabilities{
        .progress = true, .stops = true, .collisions = true, .drag_work = true};

    explicit GaussRadau(const ParameterValues& values)
        : tolerance_(kept_tolerance(static_cast<T>(values[tolerance_parameter.name]))), guard_(tolerance_) {}

    template <class System>
    void start(System& system, const State<T>& state) {
        end_ = TwoPartState<T>(state);
        begin_ = end_;
        const std::size_t count = end_.x.count();
        for (Field<T>* field : {&a_, &begin_a_, &x_, &v_, &f_, &last_a_, &next_a_}) *field = Field<T>(count);
        for (Terms* set : {&b_, &trial_, &g_}) set->fill(Field<T>(count));
        aim_ = std::min(T(Control::longest), T(Control::reach) * root(tolerance_in(system, tolerance_), 15));
        system.hold(end_.x, end_.v);
        system.accelerations(end_.x, a_);
        progress_ = {};
        progress_.last = progress_.next = first_step(aim_ * time_scale(system, end_.x, end_.v, a_), system.dt());
        guard_.state({});
        resist(system, end_.x, end_.v, a_);
    }

    template <class System>
    void step(System& system) {
        progress_.time.next_frame(system.dt());
        while (progress_.time.ahead() < 0) own_step(system);
    }

    /// Between the ends of an own step: a shorter step from its beginning, as its polynomial is of order 10 there.
    template <class System>
    void synchronised(const System& system, State<T>& out) const {
        const T ahead = static_cast<T>(progress_.time.ahead()), across = progress_.across;
        if (!(ahead > T(0))) {
            out = {end_.x, end_.v};
        } else if (across > T(0)) {
            within_crossing(before(), now(), across, T(2) * across - ahead, out);
        } else {
            const GaussRadau inside = within_last_step(system, progress_.last - ahead);
            out = {inside.end_.x, inside.end_.v};
        }
    }

    template <class System>
    double drag_work(const System& system) const {
        return drag_.sum().value() + work_in_own_step(system, static_cast<T>(progress_.time.ahead()));
    }

    const CollisionRecord& collisions() const { return guard_.record(); }
    std::optional<OwnStop> stopped() const { return progress_.stop; }

    template <class Self, class F>
    static void each_part(Self& self, F f) {
        TwoPartState<T>::each_part(self.end_, f);
        TwoPartState<T>::each_part(self.begin_, f);
        f(self.a_);
        f(self.begin_a_);
        for (auto& field : self.b_) f(field);
    }

    struct Progress {
        T last = T(0);    ///< length of the last own step
        T next = T(0);    ///< of the next one
        T across = T(0);  ///< if the last one went across a collision: the time from its beginning to there
        std::optional<OwnStop> stop;
        bool crossed = false;  ///< at the end of the last one other pairs act (encounters.hpp)
        InnerTime<T> time;     ///< of own steps
        typename CollisionGuard<T>::State guard{};
    };
    Progress progress() const { return guard_.saved_in(progress_); }
    void progress(const Progress& saved) {
        progress_ = saved;
        guard_.state(saved.guard);
    }

private:
    static constexpr std::size_t terms = Radau::terms;
    using Terms = std::array<Field<T>, terms>;

    static constexpr int most_refused = 40;
    static constexpr int most_iterations = 16;
    /// Of the last two coefficients, relative to the accelerations.
    T iteration_error() const {
        return std::max(std::numeric_limits<T>::epsilon() / T(2), tolerance_ * T(Control::iteration_share));
    }

    /// The work of drag in the last own step up to a time before its end.
    template <class System>
    double work_in_own_step(const System& system, T ahead) const {
        if (!(progress_.time.since_start(system.dt()) > 0)) return 0;  // none was taken
        const T across = progress_.across, length = across > T(0) ? T(2) * across : progress_.last;
        const T since = ahead > T(0) ? length - ahead : length;
        if (across > T(0)) return work_in_crossing(drag_, before(), now(), to_double(across), to_double(since));
        if (!(ahead > T(0))) return radau_work(drag_, begin_.v, begin_a_, b_, since);
        return radau_work(drag_, begin_.v, begin_a_, within_last_step(system, since).trial_, since);
    }

    template <class System>
    void own_step(System& system) {
        constexpr T any = std::numeric_limits<T>::max();
        check_interruption();
        if (drag_.on()) drag_.add(work_in_own_step(system, T(0)));
        system.hold(end_.x, end_.v);
        if (progress_.crossed) accelerate(system, end_.x, end_.v, a_);
        progress_.next = longest_step(system, now(), progress_.next, tolerance_);
        T h = guard_.behind(progress_.next), before = any, converging = any;
        guard_.begin_step();
        if (guard_.approaching()) {
            h = guard_.before(system, now(), h, progress_.time.since_start(system.dt()));
            if (!guard_.approaching()) progress_.next = h;
        }
        const bool possible = progress_.next > T(0);
        for (int refused = 0; possible && refused < most_refused; ++refused) {
            if (guard_.at_hand()) return cross_collision(system);
            expect(guess_ratio(h, progress_.last));
            const bool converged = converge(system, h);
            if (straddles(system, h)) continue;
            if (converged && fits(h, before)) {
                progress_.next = std::min(progress_.next, converging);
                next_ = end_;
                move_radau(next_, a_, trial_, h, T(1));
                if (crosses(system, h)) continue;
                accelerate(system, next_.x, next_.v, next_a_);
                if (!has_hidden_forces(system) || is_foreseen(system, now(), trial_, next_a_, tolerance_ / h))
                    return accept(system, h);
                progress_.next = h / T(4);
            }
            if (!converged) progress_.next = converging = h / T(2);
            h = progress_.next;
        }
        progress_.stop = own_stop(system, end_.x, progress_.time.since_start(system.dt()), h);
        std::fill(end_.x.flat().begin(), end_.x.flat().end(), std::numeric_limits<T>::quiet_NaN());
        progress_.time.inner_step(system.dt());
    }

    /// True if the trial step is good; the next one has a better length. A step cut short says nothing about longer
    /// ones. A phase that does not fall with the step is rounding, for which no shorter step is better, unless the
    /// accelerations change velocities by more than the tolerance: then they jump where the step begins.
    bool fits(T h, T& before) {
        const T covered = phase(h), factor = step_factor(aim_, covered), change = T(64) * tolerance_ / h;
        const bool better_shorter = covered < T(0.95) * std::exchange(before, covered) ||
                                    squares(last_a_) > change * change * (T(1) + squares(end_.v));
        const bool refused = factor < T(smallest_accepted_factor) && better_shorter;
        if (refused || !(h < progress_.next)) progress_.next = h * factor;
        return !refused;
    }

    template <class System>
    bool straddles(System& system, T& h) {
        move_to(h, T(1));
        return any_pass(system, end_.x, x_) && std::isfinite(squares(x_)) && guard_.passes(system, now(), x_, h);
    }

    template <class System>
    bool crosses(System& system, T& h) {
        return !system.held().empty() && crosses_on_the_way(system, now(), next_.x, next_.v, h);
    }

    MotionOf<T> now() const { return {end_.x, end_.v, a_}; }
    /// Where the last own step began.
    MotionOf<T> before() const { return {begin_.x, begin_.v, begin_a_}; }

    template <class System>
    void cross_collision(System& system) {
        Motion<T> behind(a_.count());
        const T length = guard_.scale();
        progress_.across = guard_.cross(system, now(), behind, progress_.time.since_start(system.dt()));
        begin_ = end_;
        std::swap(begin_a_, a_);
        end_.x = behind.x;
        end_.v = behind.v;
        a_ = behind.a;
        progress_.crossed = system.hold(end_.x, end_.v);
        b_.fill(Field<T>(a_.count()));
        progress_.last = progress_.next = length;
        progress_.time.inner_step(T(2) * progress_.across);
    }

    template <class System>
    void accept(System& system, T h) {
        std::swap(begin_, end_);
        std::swap(end_, next_);
        std::swap(begin_a_, a_);
        std::swap(a_, next_a_);
        std::swap(b_, trial_);
        progress_.crossed = system.hold(end_.x, end_.v);
        progress_.last = h;
        progress_.across = T(0);
        progress_.time.inner_step(h);
    }

    /// After a shorter step from the beginning of the last one.
    template <class System>
    GaussRadau within_last_step(const System& system, T h) const {
        System copy = system;
        copy.hold(begin_.x, begin_.v);
        GaussRadau inside = *this;
        inside.shorten_last_step(copy, h);
        return inside;
    }

    /// The last own step taken again with the length h; its polynomial is the first guess.
    template <class System>
    void shorten_last_step(System& system, T h) {
        end_ = begin_;
        a_ = begin_a_;
        shorten_radau(b_, h / progress_.last, trial_);
        newton_form(trial_, g_);
        converge(system, h);
        move_radau(end_, a_, trial_, h, T(1));
    }

    /// First guess of b: the last step's polynomial carried on (eq. 13), without the correction by what the last guess
    /// was off (eq. 14, 15): where steps follow the motion it cost up to a fifth more evaluations.
    void expect(T ratio) {
        carry_on_radau(b_, ratio, trial_);
        newton_form(trial_, g_);
    }

    /// Passes over the nodes until the last two coefficients do not change (one alone does not now and then by chance);
    /// false if they do not settle.
    template <class System>
    bool converge(System& system, T h) {
        const T error2 = iteration_error() * iteration_error();
        constexpr T noise = T(64) * std::numeric_limits<T>::epsilon();
        const T idle = idle_accelerations(T(16) * std::numeric_limits<T>::epsilon(), squares(end_.x), h);
        T before = T(0);
        for (int i = 0; i < most_iterations; ++i) {
            visit_first(system, h, std::make_index_sequence<terms - 2>{});
            T change = visit<terms - 2>(system, h);
            change += visit<terms - 1>(system, h);
            const T forces = squares(a_) + squares(last_a_);
            if (!std::isfinite(change + forces + squares(trial_[terms - 1]))) return false;
            if (change <= error2 * forces || change <= idle) return true;
            if (i > 1 && change >= before) return change <= noise * noise * forces;
            if (i > 0 && change * (change / before) <= error2 * forces) return true;
            before = change;
        }
        return false;
    }

    template <class System, std::size_t... N>
    void visit_first(System& system, T h, std::index_sequence<N...>) {
        (visit<N>(system, h), ...);
    }

    /// The accelerations at a node, and what they change in its coefficient g, squared.
    template <std::size_t n, class System>
    T visit(System& system, T h) {
        const T s = static_cast<T>(Radau::nodes[n]);
        move_to(h, s);
        system.accelerations(x_, f_);
        if (system.drag() != T(0) || system.damped()) resist_at(system, h, s);
        T* const changes = x_.flat().data();
        const T *const f = f_.flat().data(), *const a = a_.flat().data();
        std::array<T, terms> gaps{}, weights{};
        gaps[0] = T(1) / s;
        for (std::size_t i = 0; i < n; ++i) gaps[i + 1] = static_cast<T>(1 / (Radau::nodes[n] - Radau::nodes[i]));
        for (std::size_t j = 0; j <= n; ++j) weights[j] = static_cast<T>(Radau::from_newton[n][j]);
        elementwise(a_.flat().size(), [=, g = Radau::numbers(g_), b = Radau::numbers(trial_)](std::size_t k) {
            T newest = (f[k] - a[k]) * gaps[0];
            for (std::size_t i = 0; i < n; ++i) newest = (newest - g[i][k]) * gaps[i + 1];
            const T change = newest - g[n][k];
            g[n][k] = newest;
            for (std::size_t j = 0; j <= n; ++j) b[j][k] += weights[j] * change;
            changes[k] = change;
        });
        if (n + 1 == terms) std::swap(last_a_, f_);
        return n + 2 < terms ? T(0) : squares(x_);
    }

    void move_to(T h, T s) {
        const RadauSum<T> sum{RadauWeights<T>(s).position, a_.flat().data(), Radau::numbers(std::as_const(trial_))};
        const T *const x = end_.x.flat().data(), *const v = end_.v.flat().data(),
                       *const lost = end_.lost.x.flat().data();
        T* const out = x_.flat().data();
        elementwise(a_.flat().size(), [=](std::size_t k) { out[k] = x[k] + (lost[k] + h * (s * v[k] + h * sum(k))); });
    }

    /// At a node, whose place is x_.
    template <class System>
    void resist_at(const System& system, T h, T s) {
        const RadauSum<T> sum{RadauWeights<T>(s).velocity, a_.flat().data(), Radau::numbers(std::as_const(trial_))};
        const T* const v = end_.v.flat().data();
        T* const there = v_.flat().data();
        elementwise(a_.flat().size(), [=](std::size_t k) { there[k] = v[k] + h * sum(k); });
        resist(system, x_, v_, f_);
    }

    /// omega h of the fastest motion: a motion cos(omega t) has b_6 = (omega h)^7 / 7! and b_5 = (omega h)^6 / 6! of a.
    T phase(T h) const {
        constexpr T factor_5 = 720, factor_6 = 5040, smallest = T(1) / T(64);
        const T error = std::max(tolerance_, T(1024) * std::numeric_limits<T>::epsilon());
        const T forces = (squares(a_) + squares(last_a_)) / T(2) + idle_accelerations(error, squares(end_.x), h);
        const T part_5 = factor_5 * factor_5 * (squares(trial_[5]) / forces);
        const T part_6 = factor_6 * factor_6 * (squares(trial_[6]) / forces);
        if (!(part_5 + part_6 > T(0))) return smallest;
        return std::max({smallest, square_root(square_root(root(part_5, 3))), square_root(root(part_6, 7))});
    }

    static T squares(const Field<T>& field) { return sum_of_squares(field); }

    T tolerance_;
    T aim_ = T(0);                   ///< what omega h is kept at
    TwoPartState<T> end_;            ///< of the last own step
    TwoPartState<T> begin_;          ///< its beginning
    TwoPartState<T> next_;           ///< the end of a trial step
    Field<T> a_, begin_a_, next_a_;  ///< accelerations there, drag included
    Terms b_;                        ///< of the last step
    Terms trial_, g_;
    CollisionGuard<T> guard_;
    Field<T> x_, v_, f_, last_a_;
    Progress progress_;
};

}  // namespace steplab
