#pragma once

#include "core/vec3.hpp"
#include "models/potentials/expression_potential.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace steplab {

/// A spring of a composition: F = k e + quadratic e^2 + cubic e^3 of its extension e.
struct ComposedSpring {
    std::uint32_t first = 0, second = 0;
    Vec3 rest = {};  ///< from the reference position of the first particle to that of the second
    double length = 0;
    double stretch = 0;  ///< |rest|^2 - length^2
    double k = 0, quadratic = 0, cubic = 0;
    double damping = 0;  ///< of a dashpot: force -damping times the relative velocity along the spring
};

/// A potential between the particles of two sets, or of one.
struct ComposedPairs {
    std::string potential = {};                         ///< the name of a built-in one
    std::vector<double> values = {};                    ///< of its parameters
    std::shared_ptr<const ExpressionForce> expression;  ///< instead of a built-in one, its cut-off included
    double cutoff = 0;                                  ///< 0: none
    std::vector<std::uint32_t> first, second;           ///< particles; second empty: pairs within the first
    /// Where not all of them act on each other, those that do, the lower number first: the ends of springs.
    std::vector<std::array<std::uint32_t, 2>> listed = {};

    /// A particle feels some others, not all.
    bool is_short_ranged() const { return cutoff > 0 || !listed.empty(); }
};

/// A potential that acts on particles from outside.
struct ComposedField {
    std::shared_ptr<const ExpressionForce> expression;
    bool along_y = true, along_z = true;  ///< whether it can pull along these axes
    std::vector<std::uint32_t> particles;
};

/// What acts on the particles of a scene that no other layout has, as plain data in double.
struct Composition {
    std::size_t count = 0;
    double mass = 1;              ///< in units of which `masses` are; of each particle where that is empty
    std::vector<double> masses;   ///< of each particle divided by `mass`; empty where all are 1
    std::vector<double> charges;  ///< of each particle; empty where all are 0
    std::vector<char> fixed;      ///< empty where all particles move
    std::vector<Vec3> reference;  ///< positions; empty where all are the origin, as they are with pairs and in a box
    std::vector<double> drag;     ///< rate c / m of each particle; empty where it is the same for all (Plan::drag)
    std::vector<ComposedSpring> springs;
    std::vector<ComposedPairs> pairs;
    std::vector<ComposedField> fields;
    std::vector<Vec3>
        accelerations;  ///< from outside, of each particle; one for all where they are equal; may be empty
    Vec3 box;           ///< sides of space that repeats itself; 0: not along this axis

    /// Dashpots, or drag that differs between particles.
    bool is_damped() const {
        return !drag.empty() ||
               std::any_of(springs.begin(), springs.end(), [](const auto& s) { return s.damping > 0; });
    }
};

/// Any forces between any particles.  composed.hpp
struct ComposedForces {
    std::size_t count = 0;
    double mass = 1;
    std::shared_ptr<const Composition> terms;
    /// Number of threads that share the work; the sums do not depend on it.
    std::size_t threads = 1;
};

}  // namespace steplab
