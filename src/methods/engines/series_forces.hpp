#pragma once

#include "core/coupling.hpp"
#include "core/field.hpp"
#include "core/force_layout.hpp"
#include "core/lanes.hpp"
#include "methods/engines/moving_axes.hpp"
#include "methods/engines/power_series.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <type_traits>
#include <vector>

namespace steplab {

/// The accelerations of a scene as power series in time: the formula of each interaction, evaluated order by order over
/// the series of its particles' displacements. The face behind which the layout of forces is known.
template <class T>
class SeriesForces {
public:
    virtual ~SeriesForces() = default;

    /// 1 if all motion is along x, 2 if in the plane of x and y, else 3.
    std::size_t axes() const { return axes_; }
    /// Two particles are at one place, where there is no series.
    bool singular() const { return singular_; }

    /// The interactions at the beginning of the series, in batches of one kind. Pairs that move together do not act on
    /// each other: they are left out, and searched for again as long as there are any.
    virtual void find_interactions(const Field<T>& displacement, const Field<T>& velocity) = 0;
    /// Coefficient k of the accelerations, into `out`, from that of the displacements and all before it.
    virtual void accelerations(const Field<T>& x_k, std::size_t k, Field<T>& out) = 0;

protected:
    explicit SeriesForces(std::size_t axes) : axes_(axes) {}

    std::size_t axes_;
    bool singular_ = false;
};

/// The same of one layout of forces, a register of interactions at a time.
template <class T, class Force>
class SeriesForcesOf final : public SeriesForces<T> {
public:
    /// For series of `length` coefficients of the accelerations, from this state on. `force` is referred to.
    SeriesForcesOf(Force& force, const State<T>& state, std::size_t length)
        : SeriesForces<T>(moving_axes(force, state)),
          force_(force),
          length_(length),
          fixed_(fixed_particles(force, state.displacement.count())),
          kept_(kept_by_formulas(force)) {}

    void find_interactions(const Field<T>& displacement, const Field<T>& velocity) override {
        const Coupling coupling = force_.coupling();
        const bool each_on_each = coupling.kind == Coupling::Kind::near || coupling.kind == Coupling::Kind::all;
        const bool known = !batches_.empty() && !coupling.cut;
        if (known && !(each_on_each && (singular_ || left_out_))) return;
        batches_.clear();
        left_out_ = false;
        force_.each_interaction(displacement, [&](std::size_t i, std::size_t j, std::size_t kind) {
            if (each_on_each && i != j && move_together(displacement, velocity, i, j)) {
                left_out_ = true;
            } else {
                append(i, j, kind);
            }
        });
        tapes_.resize(batches_.size() * kept_ * length_);
    }

    void accelerations(const Field<T>& x_k, std::size_t k, Field<T>& out) override {
        if (axes_ == 1) return accelerations_along<1>(x_k, k, out);
        if constexpr (formulas_of_one_kind) {
            if (axes_ == 2) return accelerations_along<2>(x_k, k, out);
        }
        accelerations_along<3>(x_k, k, out);
    }

private:
    using N = Lanes<T>;
    using SeriesForces<T>::axes_, SeriesForces<T>::singular_;

    /// Those that choose among laws are long: compiled for one axis and for all.
    static constexpr bool formulas_of_one_kind = !Force::capabilities.masses;

    /// What the pull is multiplied by for the first and the second particles of a batch, and what the formula is told
    /// of them.
    struct Differing {
        std::array<T, N::count> to_first{}, to_second{};
        std::array<PairProperties<T>, N::count> properties{};
    };
    struct Alike {};

    /// Interactions of one kind whose series are computed together, one in each SIMD lane.
    struct Batch {
        std::size_t kind = 0, count = 0;
        std::array<std::uint32_t, N::count> first{}, second{};  ///< beyond `count` the first pair again
        [[no_unique_address]] std::conditional_t<Force::capabilities.masses, Differing, Alike> particles{};

        /// From outside, on the first particles.
        bool external() const { return first[0] == second[0]; }
    };

    void append(std::size_t i, std::size_t j, std::size_t kind) {
        if (batches_.empty() || batches_.back().kind != kind || batches_.back().count == N::count) {
            batches_.push_back({.kind = kind, .count = 0});
            batches_.back().first.fill(static_cast<std::uint32_t>(i));
            batches_.back().second.fill(static_cast<std::uint32_t>(j));
            if constexpr (Force::capabilities.masses)
                batches_.back().particles.properties.fill(force_.properties(i, j, kind));
        }
        Batch& batch = batches_.back();
        batch.first[batch.count] = static_cast<std::uint32_t>(i);
        batch.second[batch.count] = static_cast<std::uint32_t>(j);
        if constexpr (Force::capabilities.masses) {
            batch.particles.properties[batch.count] = force_.properties(i, j, kind);
            batch.particles.to_first[batch.count] = force_.inverse_mass(i);
            batch.particles.to_second[batch.count] = i == j ? T(0) : force_.inverse_mass(j);
        }
        ++batch.count;
    }

    template <std::size_t Axes>
    void accelerations_along(const Field<T>& x_k, std::size_t k, Field<T>& out) {
        const auto a = components(out);
        if (k == 0) singular_ = false;
        std::fill_n(out.flat().data(), out.flat().size() / 3 * Axes, T(0));
        if (k == 0) add_external(out);
        const auto formulas = force_.formulas();
        const std::size_t length = length_;
        for (std::size_t b = 0; b < batches_.size(); ++b) {
            const Batch& batch = batches_[b];
            SeriesTape<T> tape(tapes_.data() + b * kept_ * length, length, k);
            const auto pull = pulls<Axes>(tape, formulas[batch.kind], batch, arguments<Axes>(batch, x_k, k));
            singular_ = singular_ || tape.singular();
            for (std::size_t axis = 0; axis < Axes; ++axis) scatter(batch, pull[axis], a[axis]);
        }
        for (const std::size_t i : fixed_) {
            for (T* const component : a) component[i] = T(0);
        }
    }

    /// At one place with one velocity, in a scene where all others act on both equally. Their distance, which counts as
    /// 0 where its square underflows, stays 0.
    bool move_together(const Field<T>& x, const Field<T>& v, std::size_t i, std::size_t j) const {
        const auto square = [](T a, T b, T c) { return a * a + b * b + c * c; };
        const auto d = force_.separation(x, i, j);
        return square(d.x, d.y, d.z) == T(0) &&
               square(v.x()[j] - v.x()[i], v.y()[j] - v.y()[i], v.z()[j] - v.z()[i]) == T(0);
    }

    static std::array<T*, 3> components(Field<T>& field) { return {field.x(), field.y(), field.z()}; }
    static std::array<const T*, 3> components(const Field<T>& field) { return {field.x(), field.y(), field.z()}; }

    /// Coefficient k of what the formula of a batch is given.
    template <std::size_t Axes>
    [[gnu::always_inline]] std::array<N, Axes> arguments(const Batch& batch, const Field<T>& x_k, std::size_t k) const {
        const std::array<const T*, 3> u = components(x_k);
        std::array<N, Axes> e;
        if constexpr (Force::capabilities.fields) {
            if (batch.external()) return places<Axes>(batch, x_k, k);
        }
        for (std::size_t axis = 0; axis < Axes; ++axis) {
            const T* const along = u[axis];
            e[axis] = N::each([&](std::size_t lane) { return along[batch.second[lane]] - along[batch.first[lane]]; });
        }
        if constexpr (Force::capabilities.periodic) {
            if (k > 0) return e;
            return vectors<Axes>(
                [&](std::size_t lane) { return force_.difference(x_k, batch.first[lane], batch.second[lane]); });
        }
        return e;
    }

    /// The same of what acts from outside: the position.
    template <std::size_t Axes>
    std::array<N, Axes> places(const Batch& batch, const Field<T>& x_k, std::size_t k) const {
        return vectors<Axes>([&](std::size_t lane) {
            const std::size_t i = batch.first[lane];
            return k == 0 ? force_.place(x_k, i) : Vector<T>{x_k.x()[i], x_k.y()[i], x_k.z()[i]};
        });
    }

    template <std::size_t Axes, class VectorOf>
    static std::array<N, Axes> vectors(VectorOf vector_of) {
        std::array<N, Axes> lanes;
        lanes[0] = N::each([&](std::size_t lane) { return vector_of(lane).x; });
        if constexpr (Axes > 1) lanes[1] = N::each([&](std::size_t lane) { return vector_of(lane).y; });
        if constexpr (Axes > 2) lanes[2] = N::each([&](std::size_t lane) { return vector_of(lane).z; });
        return lanes;
    }

    /// Coefficient k of the pulls of a batch. Flattened, so that the formula's intermediate results stay in registers.
    template <std::size_t Axes, class Formula>
    [[gnu::flatten]] std::array<N, Axes> pulls(SeriesTape<T>& tape, const Formula& formula, const Batch& batch,
                                               const std::array<N, Axes>& e) const {
        const std::size_t moving = formulas_of_one_kind ? Axes : axes_;
        const auto variable = [&](std::size_t axis) {
            if (axis >= moving) return Series<T>(T(0));
            return Series<T>::variable(tape, e[axis]);
        };
        const Series<T> x = variable(0), y = variable(1), z = variable(2);
        const Vector<Series<T>> pull = pulled(formula, batch, x, y, z);
        std::array<N, Axes> coefficients;
        coefficients[0] = pull.x.coefficient();
        if constexpr (Axes > 1) coefficients[1] = pull.y.coefficient();
        if constexpr (Axes > 2) coefficients[2] = pull.z.coefficient();
        return coefficients;
    }

    template <class Formula>
    [[gnu::always_inline]] static Vector<Series<T>> pulled(const Formula& formula, const Batch& batch,
                                                           const Series<T>& x, const Series<T>& y, const Series<T>& z) {
        if constexpr (Force::capabilities.masses) {
            const auto of = [&](T PairProperties<T>::*property) {
                return Series<T>::constant(
                    N::each([&](std::size_t lane) { return batch.particles.properties[lane].*property; }));
            };
            using P = PairProperties<T>;
            return formula(x, y, z,
                           PairProperties<Series<T>>{of(&P::first_mass), of(&P::second_mass), of(&P::first_charge),
                                                     of(&P::second_charge)});
        } else {
            return formula(x, y, z);
        }
    }

    static void scatter(const Batch& batch, N pull, T* a) {
        for (std::size_t lane = 0; lane < batch.count; ++lane) {
            if constexpr (Force::capabilities.masses) {
                a[batch.first[lane]] += batch.particles.to_first[lane] * pull[lane];
                a[batch.second[lane]] -= batch.particles.to_second[lane] * pull[lane];
            } else {
                a[batch.first[lane]] += pull[lane];
                a[batch.second[lane]] -= pull[lane];
            }
        }
    }

    void add_external(Field<T>& a) const {
        for (std::size_t i = 0; i < a.count(); ++i) {
            const auto external = force_.external(i);
            a.x()[i] = external.x;
            a.y()[i] = external.y;
            a.z()[i] = external.z;
        }
    }

    static std::vector<std::size_t> fixed_particles(const Force& force, std::size_t count) {
        std::vector<std::size_t> fixed;
        for (std::size_t i = 0; i < count; ++i) {
            if (!force.moves(i)) fixed.push_back(i);
        }
        return fixed;
    }

    /// Series that the formulas keep for each batch.
    static std::size_t kept_by_formulas(const Force& force) {
        std::vector<N, CacheLineAllocator<N>> memory(SeriesTape<T>::most_kept);
        std::size_t kept = 0;
        const Batch any;
        for (const auto& formula : force.formulas()) {
            SeriesTape<T> tape(memory.data(), 1, 0);
            const auto e = [&tape] { return Series<T>::variable(tape, N(T(1))); };
            pulled(formula, any, e(), e(), e());
            kept = std::max(kept, tape.kept());
        }
        return kept;
    }

    Force& force_;
    std::size_t length_;
    std::vector<std::size_t> fixed_;
    std::size_t kept_;
    bool left_out_ = false;  ///< pairs that move together
    std::vector<Batch> batches_;
    std::vector<N, CacheLineAllocator<N>> tapes_;  ///< of each batch: the series it keeps, one after the other
};

/// Of a layout of forces that is known; erased_force.hpp has that of others.
template <class T, class Force>
std::unique_ptr<SeriesForces<T>> series_forces(Force& force, const State<T>& state, std::size_t length) {
    return std::make_unique<SeriesForcesOf<T, Force>>(force, state, length);
}

}  // namespace steplab
