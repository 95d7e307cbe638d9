#pragma once

#include "core/vec3.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace steplab {

/// A spring of a composition: F = k e + quadratic e^2 + cubic e^3 of its extension e.
struct ComposedSpring {
    std::uint32_t first = 0, second = 0;
    Vec3 rest = {};  ///< from the reference position of the first particle to that of the second
    double length = 0;
    double stretch = 0;  ///< |rest|^2 - length^2
    double k = 0, quadratic = 0, cubic = 0;
};

/// A potential between the particles of two sets, or of one. Parameters as in docs/scene-files.md.
struct ComposedPairs {
    enum class Potential { morse, lennard_jones, gravity, coulomb };
    Potential potential = Potential::morse;
    double depth = 1, k = 1, r0 = 1;           ///< morse: D, k, r0
    double epsilon = 1, sigma = 1;             ///< lennard_jones
    double strength = 1, softening = 0;        ///< gravity: G; coulomb: K
    double cutoff = 0;                         ///< 0: none
    std::vector<std::uint32_t> first, second;  ///< particles; second empty: pairs within the first
};

/// What acts on the particles of a scene that no other layout has, as plain data in double.
struct Composition {
    std::size_t count = 0;
    double mass = 1;              ///< in units of which `masses` are; of each particle where that is empty
    std::vector<double> masses;   ///< of each particle divided by `mass`; empty where all are 1
    std::vector<double> charges;  ///< empty where nothing asks for them
    std::vector<char> fixed;      ///< empty where all particles move
    std::vector<Vec3> reference;  ///< positions; empty where all are the origin, as they are with pairs and in a box
    std::vector<ComposedSpring> springs;
    std::vector<ComposedPairs> pairs;
    std::vector<Vec3>
        accelerations;  ///< from outside, of each particle; one for all where they are equal; may be empty
    Vec3 box;           ///< sides of space that repeats itself; 0: not along this axis
};

/// Any forces between any particles.  composed.hpp
struct ComposedForces {
    std::size_t count = 0;
    double mass = 1;
    std::shared_ptr<const Composition> terms;
};

}  // namespace steplab
