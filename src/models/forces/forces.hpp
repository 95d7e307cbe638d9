#pragma once

#include "core/coupling.hpp"
#include "core/field.hpp"
#include "models/forces/composition.hpp"

#include <algorithm>
#include <cstddef>
#include <memory>
#include <variant>

namespace steplab {

/// Forces that depend on position: one description per layout, in double, as models provide it. All particles of a
/// scene have the same mass. Each layout has a templated engine in the header of its name.

/// Every particle has its own constant acceleration (0, -step * i, 0), i its index.  constant.hpp
struct ConstantForces {
    std::size_t count = 0;
    double mass = 1;
    double step = 0.1;
};

/// Springs between neighbours in a line whose reference positions are (i L, 0, 0), and gravity.  line.hpp
struct LineForces {
    std::size_t count = 0;
    bool first_fixed = true;
    double mass = 1;
    double k = 1;            ///< force constant of a spring
    double rest_length = 1;  ///< L: of a spring, and distance between neighbours in the reference positions
    double gravity = 0;      ///< acceleration along -y
};

/// Springs to the 8 neighbours of a grid in the xz plane, its border fixed.  grid.hpp
struct GridForces {
    std::size_t rows = 0;
    std::size_t columns = 0;
    double mass = 1;
    double k = 1;
    double rest_length = 1;  ///< of the springs along the axes; sqrt(2) times it for the diagonal ones
};

/// Morse potential between all pairs.  pairs.hpp
struct PairForces {
    std::size_t count = 0;
    double mass = 1;
    double depth = 1;  ///< D
    double k = 0.5;    ///< force constant at r0: b = sqrt(k / (2 D))
    double r0 = 0.5;
    /// Subtracted from the accelerations: with those of a state, it becomes an equilibrium. Null: nothing.
    std::shared_ptr<const Field<double>> balance = nullptr;
};

/// Morse potential between pairs nearer than `cutoff`, shifted to zero there together with its slope.  near_pairs.hpp
struct NearPairForces : PairForces {
    double cutoff = 1;
    /// Side of the periodic box, at least twice the cut-off (minimum image); 0: no periodic boundary conditions.
    double period = 0;
    /// Number of threads that share the work; the sums do not depend on it.
    std::size_t threads = 1;
};

using Forces = std::variant<ConstantForces, LineForces, GridForces, PairForces, NearPairForces, ComposedForces>;

/// Which particles act on which.
inline Coupling coupling(const ConstantForces& forces) { return {Coupling::Kind::none, forces.count}; }
inline Coupling coupling(const LineForces& forces) { return {Coupling::Kind::chain, forces.count}; }
inline Coupling coupling(const GridForces& forces) { return {Coupling::Kind::sheet, forces.rows * forces.columns}; }
inline Coupling coupling(const PairForces& forces) { return {Coupling::Kind::all, forces.count}; }
inline Coupling coupling(const NearPairForces& forces) { return {Coupling::Kind::near, forces.count, true, true}; }
inline Coupling coupling(const ComposedForces& forces) {
    const Composition& terms = *forces.terms;
    const auto smooth = [](const auto& term) { return !term.expression || term.expression->force.is_smooth(); };
    const bool all_smooth = std::all_of(terms.pairs.begin(), terms.pairs.end(), smooth) &&
                            std::all_of(terms.fields.begin(), terms.fields.end(), smooth);
    const auto is_cut = [](const ComposedPairs& pairs) { return pairs.cutoff > 0; };
    const bool some_cut = std::any_of(terms.pairs.begin(), terms.pairs.end(), is_cut);
    const auto of_kind = [&](Coupling::Kind kind) { return Coupling{kind, forces.count, all_smooth, some_cut}; };
    if (terms.pairs.empty()) return of_kind(terms.springs.empty() ? Coupling::Kind::none : Coupling::Kind::near);
    const bool all_near = std::all_of(terms.pairs.begin(), terms.pairs.end(),
                                      [](const ComposedPairs& pairs) { return pairs.is_short_ranged(); });
    return of_kind(all_near ? Coupling::Kind::near : Coupling::Kind::all);
}

/// Potential energy of a state in the parts that the tests of energy need.
struct PotentialEnergy {
    double value = 0;      ///< all potentials
    double magnitude = 0;  ///< sum of their absolute values
    double external = 0;   ///< of gravity and constant forces alone; part of `value`
};

}  // namespace steplab
