#pragma once

#include "core/entry.hpp"
#include "core/field.hpp"
#include "core/field_lanes.hpp"
#include "methods/engines/compensated.hpp"
#include "methods/engines/integrator.hpp"
#include "methods/engines/particles.hpp"
#include "methods/engines/runge_kutta_steps.hpp"
#include "methods/engines/synchronised.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <utility>

namespace steplab {

/// An explicit Runge-Kutta method as its Butcher table (Hairer, Norsett, Wanner, Solving Ordinary Differential
/// Equations I, II.1): stage i starts from y + dt (a[i][0] k_0 + ... + a[i][i-1] k_(i-1)), the step ends at
/// y + dt (b[0] k_0 + ...).
template <std::size_t Stages>
struct ButcherTable {
    static constexpr std::size_t stages = Stages;
    std::array<std::array<double, Stages>, Stages> a;
    std::array<double, Stages> b;
};

/// Runs an explicit Runge-Kutta method on (x, v)' = (v, a(x) - gamma v) each of whose stages starts along the slope of
/// the one before alone. `Table::table` is its Butcher table; the compiler unrolls its stages and drops the zeros of
/// its weights. Slopes enter the end of the step from left to right, as they come.
template <class T, class Table>
class RungeKutta : public Synchronised<T> {
public:
    static constexpr IntegratorCapabilities capabilities{
        .forcing = Forcing::runge_kutta, .lanes = true, .advances = true, .emits = true, .reach = true};

    explicit RungeKutta(const ParameterValues& values) : Synchronised<T>(values) {}

    static std::vector<RungeKuttaStage<T>> stages_of_steps() {
        std::vector<RungeKuttaStage<T>> all;
        for (std::size_t i = 0; i < stages; ++i) {
            all.push_back({.weight = static_cast<T>(table.b[i]),
                           .ahead = static_cast<T>(i + 1 < stages ? table.a[i + 1][i] : 0),
                           .counts = table.b[i] != 0});
        }
        return all;
    }

    template <class System>
    void start(System&, State<T> state) {
        this->begin(std::move(state));
        if constexpr (stages > 1) temporary_.fill(Field<T>(x_.count()));
    }

    template <class System>
    void step(System& system) {
        advance(system, 1);
    }
    template <class System>
    void advance(System& system, std::uint64_t steps) {
        Fields fields{&x_, &v_};
        for (std::size_t q = 2; q < quantities; ++q) fields[q] = &temporary_[q - 2];
        fields[quantities] = &lost_.x, fields[quantities + 1] = &lost_.v;
        const Stage stage{system.dt(), system.drag(), lost_.kept()};
        if constexpr (System::can_be_damped) {
            if (system.damped()) return advance_damped(system, fields, steps, stage);
        }
        system.sweep(fields, steps, stages, stage);
    }

    std::size_t reach() const { return stages; }

private:
    using Synchronised<T>::x_, Synchronised<T>::v_, Synchronised<T>::lost_;
    using N = Lanes<T>;

    static constexpr auto& table = Table::table;
    static constexpr std::size_t stages = std::remove_cvref_t<decltype(Table::table)>::stages;

    /// Position and velocity; those of a stage, whose velocity is the slope of the position; what the slopes so far
    /// give the end of the step.
    enum : std::size_t { x, v, stage_x, stage_v, sum_x, sum_v };
    static constexpr std::size_t quantities = stages > 1 ? 6 : 2;
    /// These, and what rounding has cut off positions and velocities: empty where it is not kept.
    using Fields = std::array<Field<T>*, quantities + 2>;
    struct Stage;

    /// The same with damping, which acts on the velocities of a stage.
    template <class System>
    void advance_damped(System& system, const Fields& fields, std::uint64_t steps, const Stage& stage) {
        Field<T> accelerations(x_.count());
        InMemory<T, quantities + 2, 3> particles(fields);
        const InMemory<T, 1, 3> changes({&accelerations});
        const std::size_t registers = (x_.count() + N::count - 1) / N::count;
        for (std::uint64_t part = 0; part < steps * stages; ++part) {
            const Field<T>& velocity = part % stages == 0 ? v_ : temporary_[1];
            stage(part % stages, [&](auto q, auto sink) {
                system.accelerations(*fields[q], accelerations);
                system.add_damping(*fields[q], velocity, accelerations);
                for (std::size_t r = 0; r < registers; ++r) sink(particles, r, changes.get(0, r));
            });
        }
    }

    static constexpr bool starts_from_one_slope() {
        for (std::size_t i = 0; i < stages; ++i) {
            for (std::size_t j = 0; j < stages; ++j) {
                if (j + 1 != i && table.a[i][j] != 0) return false;
            }
        }
        return true;
    }
    static_assert(starts_from_one_slope());

    /// True if none of the slopes before this one has a weight.
    static constexpr bool none_counts_before(std::size_t i) {
        return std::all_of(table.b.begin(), table.b.begin() + i, [](double weight) { return weight == 0; });
    }

    /// What a sweep does with the accelerations (sweeps.hpp).
    struct Stage {
        static constexpr std::size_t in_registers = quantities;

        T dt, drag;
        bool compensated;

        template <class F>
        [[gnu::always_inline]] void operator()(std::size_t part, F f) const {
            if (part + 1 == stages && compensated) return take<stages - 1, true>(f);
            [&]<std::size_t... I>(std::index_sequence<I...>) __attribute__((always_inline)) {
                ((part == I ? take<I, false>(f) : void()), ...);
            }
            (std::make_index_sequence<stages>{});
        }

        /// Only the last stage, which ends the step, asks whether its sums are compensated.
        template <std::size_t I, bool Compensated, class F>
        [[gnu::always_inline]] void take(F f) const {
            f(
                std::integral_constant < std::size_t, I == 0 ? x : stage_x > {},
                [ h = N(dt), gamma = N(drag), damped = drag != T(0) ](auto& particles, std::size_t r, Vector<N> a)
                    __attribute__((always_inline)) {
                        const Vector<N> slope = particles.get(I == 0 ? v : stage_v, r);
                        if (damped) a = a - gamma * slope;
                        if constexpr (I + 1 < stages) {
                            keep_sum<I>(particles, sum_x, r, slope);
                            keep_sum<I>(particles, sum_v, r, a);
                            const N ahead(static_cast<T>(table.a[I + 1][I]));
                            particles.set(stage_x, r, particles.get(x, r) + h * (ahead * slope));
                            particles.set(stage_v, r, particles.get(v, r) + h * (ahead * a));
                        } else {
                            finish<Compensated>(particles, x, r, h * sum<I>(particles, sum_x, r, slope));
                            finish<Compensated>(particles, v, r, h * sum<I>(particles, sum_v, r, a));
                        }
                    });
        }

        /// w_0 k_0 + ... + w_I k_I.
        template <std::size_t I, class Particles>
        [[gnu::always_inline]] static Vector<N> sum(Particles& particles, std::size_t q, std::size_t r,
                                                    const Vector<N>& slope) {
            const Vector<N> term = N(static_cast<T>(table.b[I])) * slope;
            if constexpr (none_counts_before(I)) return term;
            return particles.get(q, r) + term;
        }
        template <std::size_t I, class Particles>
        [[gnu::always_inline]] static void keep_sum(Particles& particles, std::size_t q, std::size_t r,
                                                    const Vector<N>& slope) {
            if constexpr (table.b[I] != 0) particles.set(q, r, sum<I>(particles, q, r, slope));
        }

        template <bool Compensated, class Particles>
        [[gnu::always_inline]] static void finish(Particles& particles, std::size_t q, std::size_t r,
                                                  const Vector<N>& change) {
            Vector<N> sum = particles.get(q, r);
            if constexpr (Compensated && Particles::quantities > quantities) {
                Vector<N> lost = particles.get(quantities + q, r);
                add_compensated(sum, lost, change);
                particles.set(quantities + q, r, lost);
            } else {
                sum = sum + change;
            }
            particles.set(q, r, sum);
        }
    };

    std::array<Field<T>, 4> temporary_;
};

}  // namespace steplab
