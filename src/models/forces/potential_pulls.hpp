#pragma once

#include "core/force_layout.hpp"
#include "core/lanes.hpp"
#include "models/forces/pair_potential.hpp"

#include <cstddef>
#include <memory>
#include <optional>
#include <utility>

namespace steplab {

/// The pulls of any pair potential that asks for no masses or charges, for sums by clusters (cluster_pulls.hpp). T is
/// float or double.
template <class T>
class PotentialPulls {
public:
    /// Numbers that are computed at once, at most.
    static constexpr std::size_t together = 64;

    PotentialPulls(std::shared_ptr<const PairPotential<T>> potential, std::shared_ptr<const ExpressionForce> expression)
        : potential_(std::move(potential)), expression_(std::move(expression)) {
        if (expression_) factors_.emplace(expression_->force);
    }

    T cutoff() const { return potential_->cutoff(); }
    void make_factors(T* distances2, std::size_t count) {
        potential_->visit([&](const auto& potential) { make(potential, distances2, count); });
    }

private:
    using Many = RegisterLanes<T, together>;

    template <class Potential>
    void make(const Potential& potential, T* distances2, std::size_t count) const {
        each<Lanes<T>>(
            distances2, count, [&](const Lanes<T>& squares) __attribute__((always_inline)) {
                return potential.factor(squares, PairProperties<Lanes<T>>{});
            });
    }
    void make(const ExpressionPotential<T>&, T* distances2, std::size_t count) {
        each<Many>(distances2, count,
                   [&](const Many& squares) { return (*factors_)(squares, PairProperties<Many>{}); });
    }

    template <class N, class Factor>
    void each(T* distances2, std::size_t count, Factor factor) const {
        const N cutoff2(cutoff() * cutoff()), zero(T(0));
        for (std::size_t k = 0; k < count; k += N::count) {
            const N squares = N::load(distances2 + k);
            const N apart = where(squares > zero, squares, N(T(1)));
            const N pull = where(squares > zero, factor(apart), zero);
            where(squares < cutoff2, pull, zero).store(distances2 + k);
        }
    }

    std::shared_ptr<const PairPotential<T>> potential_;
    std::shared_ptr<const ExpressionForce> expression_;
    std::optional<ExpressionFactors<T, Many>> factors_;
};

}  // namespace steplab
