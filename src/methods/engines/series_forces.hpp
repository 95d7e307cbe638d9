#pragma once

#include "core/coupling.hpp"
#include "core/field.hpp"
#include "core/lanes.hpp"
#include "methods/engines/moving_axes.hpp"
#include "methods/engines/power_series.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace steplab {

/// The accelerations of a scene as power series in time: the formula of each interaction, run order by order over the
/// series of its particles' displacements, a register of interactions side by side.
template <class T>
class SeriesForces {
public:
    SeriesForces() = default;
    /// For series of `length` coefficients of the accelerations, from this state on.
    template <class System>
    SeriesForces(const System& system, const State<T>& state, std::size_t length)
        : length_(length),
          axes_(moving_axes(system, state)),
          fixed_(fixed_particles(system, state.displacement.count())),
          kept_(kept_by_formulas(system)) {}

    /// 1 if all happens along x, 2 if in the plane of x and y, else 3.
    std::size_t axes() const { return axes_; }
    /// Two particles are at one place, where there is no series.
    bool singular() const { return singular_; }

    /// The interactions at the beginning of the series, in groups of one kind. Pairs that move together do not act on
    /// each other: they are left out, and looked for again as long as there are any.
    template <class System>
    void find_groups(System& system, const Field<T>& displacement, const Field<T>& velocity) {
        const Coupling::Kind kind_of_coupling = system.force().coupling().kind;
        const bool each_on_each = kind_of_coupling == Coupling::Kind::near || kind_of_coupling == Coupling::Kind::all;
        const bool known = !groups_.empty() && kind_of_coupling != Coupling::Kind::near;
        if (known && !(each_on_each && (singular_ || left_out_))) return;
        groups_.clear();
        left_out_ = false;
        system.force().each_interaction(displacement, [&](std::size_t i, std::size_t j, std::size_t kind) {
            if (each_on_each && move_together(system, displacement, velocity, i, j)) {
                left_out_ = true;
                return;
            }
            if (groups_.empty() || groups_.back().kind != kind || groups_.back().count == N::count) {
                groups_.push_back({.kind = kind, .count = 0});
                groups_.back().first.fill(static_cast<std::uint32_t>(i));
                groups_.back().second.fill(static_cast<std::uint32_t>(j));
            }
            Group& group = groups_.back();
            group.first[group.count] = static_cast<std::uint32_t>(i);
            group.second[group.count] = static_cast<std::uint32_t>(j);
            ++group.count;
        });
        tapes_.resize(groups_.size() * kept_ * length_);
    }

    /// Coefficient k of the accelerations, into `out`, from that of the displacements and all before it.
    template <std::size_t Axes, class System>
    void accelerations(const System& system, const Field<T>& x_k, std::size_t k, Field<T>& out) {
        const auto a = components(out);
        if (k == 0) singular_ = false;
        std::fill_n(out.flat().data(), out.flat().size() / 3 * Axes, T(0));
        if (k == 0) add_external(system, out);
        const auto formulas = system.force().formulas();
        const std::size_t length = length_;
        for (std::size_t g = 0; g < groups_.size(); ++g) {
            const Group& group = groups_[g];
            SeriesTape<T> tape(tapes_.data() + g * kept_ * length, length, k);
            const auto pull = pulls<Axes>(tape, formulas[group.kind], differences<Axes>(system, group, x_k, k));
            singular_ = singular_ || tape.singular();
            for (std::size_t axis = 0; axis < Axes; ++axis) scatter(group, pull[axis], a[axis]);
        }
        for (const std::size_t i : fixed_) {
            for (T* const component : a) component[i] = T(0);
        }
    }

private:
    using N = Lanes<T>;

    /// At one place with one velocity, in a scene where all others act on both alike. Their distance, which counts as 0
    /// where its square is lost, stays 0.
    template <class System>
    static bool move_together(const System& system, const Field<T>& x, const Field<T>& v, std::size_t i,
                              std::size_t j) {
        const auto square = [](T a, T b, T c) { return a * a + b * b + c * c; };
        const auto d = system.separation(x, i, j);
        return square(d.x, d.y, d.z) == T(0) &&
               square(v.x()[j] - v.x()[i], v.y()[j] - v.y()[i], v.z()[j] - v.z()[i]) == T(0);
    }

    /// Interactions of one kind whose series are computed side by side.
    struct Group {
        std::size_t kind = 0, count = 0;
        std::array<std::uint32_t, N::count> first{}, second{};  ///< beyond `count` the first pair again
    };

    static std::array<T*, 3> components(Field<T>& field) { return {field.x(), field.y(), field.z()}; }
    static std::array<const T*, 3> components(const Field<T>& field) { return {field.x(), field.y(), field.z()}; }

    /// Coefficient k of what the formula of a group is given.
    template <std::size_t Axes, class System>
    [[gnu::always_inline]] static std::array<N, Axes> differences(const System& system, const Group& group,
                                                                  const Field<T>& x_k, std::size_t k) {
        const std::array<const T*, 3> u = components(x_k);
        std::array<N, Axes> e;
        for (std::size_t axis = 0; axis < Axes; ++axis) {
            const T* const along = u[axis];
            e[axis] = N::each([&](std::size_t lane) { return along[group.second[lane]] - along[group.first[lane]]; });
        }
        if constexpr (requires { system.force().difference(x_k, 0, 0); }) {
            if (k > 0) return e;
            const auto of = [&](auto component) {
                return N::each([&](std::size_t lane) {
                    return component(system.force().difference(x_k, group.first[lane], group.second[lane]));
                });
            };
            e[0] = of([](const Vector<T>& d) { return d.x; });
            if constexpr (Axes > 1) e[1] = of([](const Vector<T>& d) { return d.y; });
            if constexpr (Axes > 2) e[2] = of([](const Vector<T>& d) { return d.z; });
        }
        return e;
    }

    /// Coefficient k of the pulls of a group. Flattened, so that the formula's intermediate results stay in registers.
    template <std::size_t Axes, class Formula>
    [[gnu::flatten]] static std::array<N, Axes> pulls(SeriesTape<T>& tape, const Formula& formula,
                                                      const std::array<N, Axes>& e) {
        const auto variable = [&](std::size_t axis) {
            if (axis >= Axes) return Series<T>(T(0));
            return Series<T>::variable(tape, e[axis]);
        };
        const Series<T> x = variable(0), y = variable(1), z = variable(2);
        const auto pull = formula(x, y, z);
        std::array<N, Axes> coefficients;
        coefficients[0] = pull.x.coefficient();
        if constexpr (Axes > 1) coefficients[1] = pull.y.coefficient();
        if constexpr (Axes > 2) coefficients[2] = pull.z.coefficient();
        return coefficients;
    }

    static void scatter(const Group& group, N pull, T* a) {
        for (std::size_t lane = 0; lane < group.count; ++lane) {
            a[group.first[lane]] += pull[lane];
            a[group.second[lane]] -= pull[lane];
        }
    }

    template <class System>
    static void add_external(const System& system, Field<T>& a) {
        for (std::size_t i = 0; i < a.count(); ++i) {
            const auto external = system.force().external(i);
            a.x()[i] = external.x;
            a.y()[i] = external.y;
            a.z()[i] = external.z;
        }
    }

    template <class System>
    static std::vector<std::size_t> fixed_particles(const System& system, std::size_t count) {
        std::vector<std::size_t> fixed;
        for (std::size_t i = 0; i < count; ++i) {
            if (!system.force().moves(i)) fixed.push_back(i);
        }
        return fixed;
    }

    /// Series that the formulas keep for each group.
    template <class System>
    static std::size_t kept_by_formulas(const System& system) {
        std::array<N, SeriesTape<T>::most_kept> memory;
        std::size_t kept = 0;
        for (const auto& formula : system.force().formulas()) {
            SeriesTape<T> tape(memory.data(), 1, 0);
            const auto e = [&tape] { return Series<T>::variable(tape, N(T(1))); };
            formula(e(), e(), e());
            kept = std::max(kept, tape.kept());
        }
        return kept;
    }

    std::size_t length_ = 0;
    std::size_t axes_ = 3;
    std::vector<std::size_t> fixed_;
    std::size_t kept_ = 0;
    bool singular_ = false;
    bool left_out_ = false;  ///< pairs that move together
    std::vector<Group> groups_;
    std::vector<N, CacheLineAllocator<N>> tapes_;  ///< of each group: the series it keeps, one after the other
};

}  // namespace steplab
