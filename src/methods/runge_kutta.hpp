#pragma once

#include "core/elementwise.hpp"
#include "core/entry.hpp"
#include "core/field.hpp"
#include "methods/synchronised.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
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

/// Runs any explicit Runge-Kutta method on (x, v)' = (v, a(x) - gamma v). `Table::table` is its Butcher table; the
/// compiler unrolls the sums over stages and drops the zeros of the table.
template <class T, class Table>
class RungeKutta : public Synchronised<T> {
public:
    explicit RungeKutta(const ParameterValues& values) : Synchronised<T>(values) {}

    template <class System>
    void start(System&, const State<T>& state) {
        this->begin(state);
        stage_x_ = Field<T>(x_.count());
        for (auto& field : stage_v_) field = Field<T>(x_.count());
        for (auto& field : stage_a_) field = Field<T>(x_.count());
    }

    template <class System>
    void step(System& system) {
        all_stages(system, std::make_index_sequence<stages>{});
        finish(system.dt());
    }

private:
    using Synchronised<T>::x_, Synchronised<T>::v_, Synchronised<T>::lost_;

    static constexpr auto& table = Table::table;
    static constexpr std::size_t stages = std::remove_cvref_t<decltype(Table::table)>::stages;

    template <class System, std::size_t... I>
    void all_stages(System& system, std::index_sequence<I...>) {
        (stage<I>(system), ...);
    }

    /// k_i = (stage velocity, stage acceleration).
    template <std::size_t I, class System>
    void stage(System& system) {
        if constexpr (I == 0) {
            evaluate(system, x_, v_, stage_a_[0]);
        } else {
            begin_stage<I>(system.dt());
            evaluate(system, stage_x_, stage_v_[I], stage_a_[I]);
        }
    }

    template <class System>
    void evaluate(System& system, const Field<T>& x, const Field<T>& v, Field<T>& a) {
        system.accelerations(x, a);
        if (const T drag = system.drag(); drag != T(0)) {
            T* const out = a.flat().data();
            const T* const velocity = v.flat().data();
            elementwise(a.flat().size(), [=](std::size_t k) { out[k] -= drag * velocity[k]; });
        }
    }

    /// Weights of the slopes at the start of stage I, and at the end of the step.
    template <std::size_t I>
    struct StageWeights {
        static constexpr auto weights = table.a[I];
    };
    struct FinalWeights {
        static constexpr auto weights = table.b;
    };

    template <std::size_t N>
    using Slopes = std::array<const T*, N>;

    /// w_0 k_0 + ... + w_J k_J from left to right, without the terms whose weight is zero.
    template <class Weights, std::size_t J, std::size_t N>
    static T weighted_sum(const Slopes<N>& slopes, std::size_t k) {
        constexpr double weight = Weights::weights[J];
        constexpr bool first = std::all_of(Weights::weights.begin(), Weights::weights.begin() + J,
                                           [](double before) { return before == 0; });
        if constexpr (first) {
            return static_cast<T>(weight) * slopes[J][k];
        } else if constexpr (weight == 0) {
            return weighted_sum<Weights, J - 1>(slopes, k);
        } else {
            return weighted_sum<Weights, J - 1>(slopes, k) + static_cast<T>(weight) * slopes[J][k];
        }
    }

    template <std::size_t... J>
    Slopes<sizeof...(J)> slopes_of_x(std::index_sequence<J...>) const {
        return {(J == 0 ? v_ : stage_v_[J]).flat().data()...};
    }

    template <std::size_t... J>
    Slopes<sizeof...(J)> slopes_of_v(std::index_sequence<J...>) const {
        return {stage_a_[J].flat().data()...};
    }

    template <std::size_t I>
    void begin_stage(T dt) {
        const T *const x = x_.flat().data(), *const v = v_.flat().data();
        T *const next_x = stage_x_.flat().data(), *const next_v = stage_v_[I].flat().data();
        const auto of_x = slopes_of_x(std::make_index_sequence<I>{});
        const auto of_v = slopes_of_v(std::make_index_sequence<I>{});
        elementwise(x_.flat().size(), [=](std::size_t k) {
            next_x[k] = x[k] + dt * weighted_sum<StageWeights<I>, I - 1>(of_x, k);
            next_v[k] = v[k] + dt * weighted_sum<StageWeights<I>, I - 1>(of_v, k);
        });
    }

    void finish(T dt) {
        T *const x = x_.flat().data(), *const v = v_.flat().data();
        const auto of_x = slopes_of_x(std::make_index_sequence<stages>{});
        const auto of_v = slopes_of_v(std::make_index_sequence<stages>{});
        if (lost_.kept()) {
            T *const lost_x = lost_.x.flat().data(), *const lost_v = lost_.v.flat().data();
            return elementwise(x_.flat().size(), [=](std::size_t k) {
                const T slope = weighted_sum<FinalWeights, stages - 1>(of_x, k);
                add_compensated(x[k], lost_x[k], dt * slope);
                add_compensated(v[k], lost_v[k], dt * weighted_sum<FinalWeights, stages - 1>(of_v, k));
            });
        }
        elementwise(x_.flat().size(), [=](std::size_t k) {
            const T slope = weighted_sum<FinalWeights, stages - 1>(of_x, k);
            x[k] += dt * slope;
            v[k] += dt * weighted_sum<FinalWeights, stages - 1>(of_v, k);
        });
    }

    Field<T> stage_x_;
    std::array<Field<T>, stages> stage_v_;  ///< the first is not used: stage 0 starts with v itself
    std::array<Field<T>, stages> stage_a_;
};

}  // namespace steplab
