#pragma once

#include "models/scene/scene.hpp"

#include <cstddef>
#include <string>
#include <string_view>

namespace steplab::test {

/// What a random scene is to have.
struct RandomScene {
    std::string_view name;
    std::size_t least = 2, most = 8;  ///< particles in each of its two groups
    bool pairs = true;
    double cutoff = 0;       ///< 0: none
    bool some_open = false;  ///< some of several pair forces have no cut-off
    int periodic = 0;        ///< along how many axes
    bool plain = false;      ///< one pair force without masses or charges, between all
    bool network = false;    ///< springs from each particle to its neighbours in number
    bool laws = false;       ///< some springs with a pair potential in place of a law of their own
    bool damped = false;
    bool fields = true, fixed = true, spread = true;  ///< spread: masses differ
    bool rounded = true;                              ///< positions that float has exactly
};

/// One for each way in which composed forces are summed.
inline constexpr RandomScene random_scenes[]{
    {.name = "few pairs", .damped = true},
    {.name = "few pairs within a cut-off", .cutoff = 1.5},
    {.name = "springs alone", .most = 20, .pairs = false, .damped = true},
    {.name = "a network of springs", .least = 40, .most = 60, .pairs = false, .network = true},
    {.name = "springs between any places", .least = 40, .most = 60, .pairs = false, .network = true, .rounded = false},
    {.name = "many pairs", .least = 30, .most = 70, .network = true, .damped = true},
    {.name = "many pairs, some within a cut-off", .least = 30, .most = 70, .cutoff = 2, .some_open = true},
    {.name = "few in a box", .least = 4, .cutoff = 1.5, .periodic = 2, .damped = true},
    {.name = "many in a box", .least = 60, .most = 90, .cutoff = 2, .periodic = 3, .network = true, .damped = true},
    {.name = "clusters", .least = 105, .most = 120, .cutoff = 1.8, .plain = true},
    {.name = "clusters in a box", .least = 105, .most = 120, .cutoff = 1.8, .periodic = 3, .plain = true},
    {.name = "potentials along springs", .most = 20, .pairs = false, .laws = true, .damped = true},
    {.name = "potentials along springs, and pairs", .least = 4, .cutoff = 1.5, .laws = true},
    {.name = "potentials along springs in a box",
     .least = 30,
     .most = 60,
     .pairs = false,
     .periodic = 2,
     .network = true,
     .laws = true},
    {.name = "one mass", .least = 10, .most = 40, .damped = true, .spread = false},
};

/// All positions, displacements, velocities and accelerations are multiples of 15 / 1024, so that float has them
/// and their differences exactly, and so it is after turned_scene(); positions only where they are rounded. No two
/// particles are nearer than 0.2.
Scene random_scene(const RandomScene& wanted, unsigned seed);

/// All vectors of the scene turned about the axis (1, 2, 3) and moved; velocities and accelerations only turned.
Scene turned_scene(const Scene& scene, Vec3 shift);
Vec3 turned(Vec3 vector);

/// Calls f(scene, text) for some random scenes of each kind that suits.
template <class Suits, class F>
void for_scenes(unsigned each, Suits suits, F f) {
    for (const RandomScene& kind : random_scenes) {
        for (unsigned seed = 0; seed < each; ++seed) {
            RandomScene wanted = kind;
            if (suits(wanted)) f(random_scene(wanted, seed), std::string(kind.name) + ", seed " + std::to_string(seed));
        }
    }
}
inline bool any_scene(RandomScene&) { return true; }

}  // namespace steplab::test
