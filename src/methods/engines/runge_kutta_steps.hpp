#pragma once

#include "core/field.hpp"
#include "core/lanes.hpp"
#include "core/vector.hpp"
#include "methods/engines/compensated.hpp"
#include "methods/engines/step_parts.hpp"
#include "methods/engines/synchronised.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <utility>
#include <vector>

namespace steplab {

/// Takes the steps of RungeKutta, each number as that computes it, of a table that is known when the program runs: one
/// piece of code for all such methods, for runs in SIMD lanes. Slopes are kept until the end of the step: that takes
/// fewer stores than sums of them.
template <class T>
class RungeKuttaSteps : public Synchronised<T> {
public:
    RungeKuttaSteps(std::vector<RungeKuttaStage<T>> stages, const ParameterValues& values)
        : Synchronised<T>(values), stages_(std::move(stages)) {}

    template <class System>
    void start(System&, State<T> state) {
        this->begin(std::move(state));
        at_stage_ = Field<T>(x_.count());
        for (Field<T>& slopes : slopes_) slopes = Field<T>(stages_.size() * x_.count());
    }

    template <class System>
    void advance(System& system, std::uint64_t steps) {
        const std::array<Field<T>*, 7> fields{&x_, &v_, &at_stage_, &slopes_[0], &slopes_[1], &lost_.x, &lost_.v};
        system.sweep(fields, steps, stages_.size(),
                     Stage{stages_, x_.count(), system.dt(), system.drag(), lost_.kept()});
    }

private:
    using Synchronised<T>::x_, Synchronised<T>::v_, Synchronised<T>::lost_;
    using N = Lanes<T>;

    /// Positions and velocities; positions where a stage begins; of slopes those of all stages, one stage after the
    /// other, the first of the positions left out: it is v.
    enum : std::size_t { x, v, at_stage, slope_x, slope_v, lost_x, lost_v };

    /// What a sweep does with the accelerations (sweeps.hpp).
    struct Stage {
        static constexpr std::size_t in_registers = 0;

        const std::vector<RungeKuttaStage<T>>& stages;
        std::size_t count;
        T dt, drag;
        bool compensated;

        template <class F>
        [[gnu::always_inline]] void operator()(std::size_t part, F f) const {
            const std::size_t last = stages.size() - 1;
            if (part == 0 && part < last) {
                take<x, true, false>(part, f);
            } else if (part == 0) {
                take<x, true, true>(part, f);
            } else if (part < last) {
                take<at_stage, false, false>(part, f);
            } else {
                take<at_stage, false, true>(part, f);
            }
        }

        /// By itself, so that all of a sweep is compiled into it.
        template <std::size_t Q, bool First, bool Last, class F>
        [[gnu::noinline, gnu::flatten]] void take(std::size_t part, F f) const {
            f(std::integral_constant<std::size_t, Q>{}, sink<First, Last>(part));
        }

        /// Of the first stage, of the last one.
        template <bool First, bool Last>
        [[gnu::always_inline]] auto sink(std::size_t part) const {
            return [ this, part, h = N(dt), gamma = N(drag), damped = drag != T(0), ahead = N(stages[part].ahead) ](
                auto& particles, std::size_t r, Vector<N> a) __attribute__((always_inline)) {
                const std::size_t place = part * count + r;
                const Vector<N> slope = First ? particles.get(v, r) : particles.get(slope_x, place);
                if (damped) a = a - gamma * slope;
                if constexpr (Last) {
                    end<First>(particles, {x, slope_x, lost_x}, r, h, First ? slope : particles.get(v, r), slope);
                    end<First>(particles, {v, slope_v, lost_v}, r, h, First ? a : particles.get(slope_v, r), a);
                } else {
                    particles.set(slope_v, place, a);
                    particles.set(at_stage, r, particles.get(x, r) + h * (ahead * slope));
                    particles.set(slope_x, place + count, particles.get(v, r) + h * (ahead * a));
                }
            };
        }

        /// A quantity, its slopes and what rounding has cut off it.
        struct Places {
            std::size_t at, slopes, lost;
        };

        /// The end of a step, whose first and last slopes are known; of a method of one stage they are one.
        template <bool One, class Particles>
        [[gnu::always_inline]] void end(Particles& particles, const Places& q, std::size_t r, const N& h,
                                        const Vector<N>& first, const Vector<N>& last) const {
            Vector<N> sum = N(stages[0].weight) * first;
            bool begun = stages[0].counts;
            const auto take = [&](std::size_t i, const Vector<N>& slope) __attribute__((always_inline)) {
                if (!stages[i].counts) return;
                const Vector<N> term = N(stages[i].weight) * slope;
                sum = begun ? sum + term : term;
                begun = true;
            };
            if constexpr (!One) {
                for (std::size_t i = 1; i + 1 < stages.size(); ++i) take(i, particles.get(q.slopes, i * count + r));
                take(stages.size() - 1, last);
            }
            add(particles, q, r, h * sum);
        }

        template <class Particles>
        [[gnu::always_inline]] void add(Particles& particles, const Places& q, std::size_t r,
                                        const Vector<N>& change) const {
            Vector<N> sum = particles.get(q.at, r);
            if (compensated) {
                Vector<N> low = particles.get(q.lost, r);
                add_compensated(sum, low, change);
                particles.set(q.lost, r, low);
            } else {
                sum = sum + change;
            }
            particles.set(q.at, r, sum);
        }
    };

    std::vector<RungeKuttaStage<T>> stages_;
    Field<T> at_stage_;
    std::array<Field<T>, 2> slopes_;  ///< of positions and velocities
};

}  // namespace steplab
