#pragma once

#include "core/frame.hpp"
#include "sim/run/run_description.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace steplab {

/// A pair force of a scene as a function of the distance of two particles.
struct PairLaw {
    std::string name;     ///< "morse", or "gravity of particles 0 and 1" where it depends on masses or charges
    double cutoff = 0;    ///< [m]; 0: none
    double closest = 0;   ///< [m] about where it begins to push strongly, or where a plot of it may begin
    double farthest = 0;  ///< [m] up to where it is worth plotting
    std::function<double(double)> energy, force;  ///< V(r) [J]; -V'(r) [N], positive where particles push each other
    std::vector<std::uint32_t> first, second;     ///< particles; second empty: pairs within the first
    std::vector<std::array<std::uint32_t, 2>> listed = {};  ///< the only pairs, where it is a law of springs
};

/// The pair forces of a scene, of springs those with a potential of their own. Throws UsageError where the scene cannot
/// be stepped.
std::vector<PairLaw> pair_laws(const RunDescription& description);

/// Distances of pairs between which the force acts, nearest images where space is periodic, ascending: of all of them,
/// or where there are many of all partners of some particles from everywhere in the scene, of which at most `most` are
/// given, evenly chosen.
std::vector<double> distances_now(const PairLaw& law, const Frame& frame, std::size_t most);

}  // namespace steplab
