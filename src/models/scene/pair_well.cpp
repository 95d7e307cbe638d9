#include "models/scene/pair_well.hpp"

#include "core/dual.hpp"
#include "models/forces/pair_potential.hpp"
#include "models/scene/composer.hpp"

#include <cmath>

namespace steplab {

namespace {

/// The distances [m] at which a well is searched for, each so many times the one before: a force changes its sign in a
/// minimum, however narrow that is.
constexpr double least_distance = 1e-12, largest_distance = 1e12, ratio = 1.05;

/// The force of a pair divided by its distance, and its slope.
class Pull {
public:
    Pull(const PairTerm& term, const PairProperties<double>& properties)
        : potential_(uncut(term), 1), properties_(properties) {}

    double at(double r) const { return potential_.factor(r * r, properties_); }
    /// V'' where the force is 0.
    double stiffness(double r) const {
        using Number = Dual<double>;
        const auto& [first_mass, second_mass, first_charge, second_charge] = properties_;
        const PairProperties<Number> properties{first_mass, second_mass, first_charge, second_charge};
        return -r * potential_.factor(Number(r * r, 2 * r), properties).derivative;
    }

private:
    static ComposedPairs uncut(PairTerm term) {
        term.cutoff.reset();
        return pair_force_of(term, 1);
    }

    PairPotential<double> potential_;
    PairProperties<double> properties_;
};

/// Between a distance at which the particles repel each other and a larger one at which they attract each other.
PairWell well_between(const Pull& pull, double low, double high) {
    for (int halving = 0; halving < 60; ++halving) {
        const double middle = low + (high - low) / 2;
        (pull.at(middle) > 0 ? low : high) = middle;
    }
    const double stiffness = pull.stiffness(high);
    return {high, std::isfinite(stiffness) && stiffness > 0 ? stiffness : 0};
}

}  // namespace

std::optional<PairWell> pair_well(const PairTerm& term, const PairProperties<double>& properties) {
    const Pull pull(term, properties);
    double repelled = 0;
    for (double r = least_distance; r < largest_distance; r *= ratio) {
        const double here = pull.at(r);
        if (here < 0 && repelled > 0) return well_between(pull, repelled, r);
        if (here > 0) repelled = r;
    }
    return std::nullopt;
}

}  // namespace steplab
