#pragma once

#include "core/field.hpp"
#include "core/lanes.hpp"
#include "core/vector.hpp"
#include "methods/compensated.hpp"
#include "methods/synchronised.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <utility>
#include <vector>

namespace steplab {

/// A stage of an explicit Runge-Kutta method each of whose stages starts along the slope of the one before alone.
template <class T>
struct RungeKuttaStage {
    T weight{};          ///< of its slope at the end of the step
    T ahead{};           ///< how far along its slope the next stage starts, in steps
    bool counts = true;  ///< its weight is not zero
    bool first = false;  ///< it is the first that counts
    bool last = false;   ///< the step ends with it
};

/// Takes the steps of RungeKutta, each number as that computes it, of a table that is known when the program runs: one
/// piece of code for all such methods, for runs side by side.
template <class T>
class RungeKuttaSteps : public Synchronised<T> {
public:
    RungeKuttaSteps(std::vector<RungeKuttaStage<T>> stages, const ParameterValues& values)
        : Synchronised<T>(values), stages_(std::move(stages)) {}

    template <class System>
    void start(System&, State<T> state) {
        this->begin(std::move(state));
        temporary_.fill(Field<T>(x_.count()));
    }

    template <class System>
    void advance(System& system, std::uint64_t steps) {
        temporary_[0] = x_, temporary_[1] = v_;
        const std::array<Field<T>*, 8> fields{
            &x_, &v_, &temporary_[0], &temporary_[1], &temporary_[2], &temporary_[3], &lost_.x, &lost_.v};
        system.sweep(fields, steps, stages_.size(), Stage{stages_.data(), system.dt(), system.drag(), lost_.kept()});
    }

private:
    using Synchronised<T>::x_, Synchronised<T>::v_, Synchronised<T>::lost_;
    using N = Lanes<T>;

    /// As in RungeKutta, but that a stage begins at stage_x and stage_v even if it is the first.
    enum : std::size_t { x, v, stage_x, stage_v, sum_x, sum_v, lost_x, lost_v };

    /// What a sweep does with the accelerations (sweeps.hpp).
    struct Stage {
        static constexpr bool in_registers = false;

        const RungeKuttaStage<T>* stages;
        T dt, drag;
        bool compensated;

        template <class F>
        [[gnu::always_inline]] void operator()(std::size_t part, F f) const {
            f(
                std::integral_constant<std::size_t, stage_x>{},
                [ this, &stage = stages[part], h = N(dt), gamma = N(drag), damped = drag != T(0) ](
                    auto& particles, std::size_t r, Vector<N> a) __attribute__((always_inline)) {
                    const Vector<N> slope = particles.get(stage_v, r);
                    if (damped) a = a - gamma * slope;
                    move(stage, h, particles, r, {x, stage_x, sum_x, lost_x}, slope);
                    move(stage, h, particles, r, {v, stage_v, sum_v, lost_v}, a);
                });
        }

        /// Where a quantity is, where the next stage begins, what the slopes so far give and what rounding cut off.
        struct Places {
            std::size_t at, next, sum, lost;
        };

        template <class Particles>
        [[gnu::always_inline]] void move(const RungeKuttaStage<T>& stage, const N& h, Particles& particles,
                                         std::size_t r, const Places& q, const Vector<N>& slope) const {
            Vector<N> sum = N(stage.weight) * slope;
            if (!stage.first) sum = particles.get(q.sum, r) + sum;
            if (stage.last) {
                particles.set(q.next, r, finish(particles, r, q, h * sum));
            } else {
                if (stage.counts) particles.set(q.sum, r, sum);
                particles.set(q.next, r, particles.get(q.at, r) + h * (N(stage.ahead) * slope));
            }
        }

        /// Returns what the quantity is at the end of the step.
        template <class Particles>
        [[gnu::always_inline]] Vector<N> finish(Particles& particles, std::size_t r, const Places& q,
                                                const Vector<N>& change) const {
            Vector<N> end = particles.get(q.at, r);
            if (compensated) {
                Vector<N> low = particles.get(q.lost, r);
                add_compensated(end, low, change);
                particles.set(q.lost, r, low);
            } else {
                end = end + change;
            }
            particles.set(q.at, r, end);
            return end;
        }
    };

    std::vector<RungeKuttaStage<T>> stages_;
    std::array<Field<T>, 4> temporary_;
};

}  // namespace steplab
