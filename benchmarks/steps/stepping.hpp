#pragma once

#include "../composed_loops.hpp"
#include "core/vec3.hpp"

#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace steplab::benchmark {

/// A run under way.
struct Stepping {
    std::function<void(std::size_t steps)> advance;  ///< goes on from where it stands
    std::function<std::string()> hash;               ///< of the state, where results have to be known bits; else empty
};

/// Somebody who can take the steps of a run.
struct Contestant {
    std::string who;
    std::function<Stepping()> start;
};

/// Some who take turns at the same, in batches of so many steps each.
struct Comparison {
    struct Entry {
        Contestant contestant;
        std::size_t steps;
        std::size_t warm_up = 0;  ///< steps before, at least; some are always taken
    };
    std::string name;           ///< row/method/precision
    std::size_t particles = 0;  ///< or numbers, whatever a step goes over
    std::vector<Entry> entries;
};

/// What every peer is given.
struct Problem {
    std::string_view model, method;
    double dt = 0;
    std::vector<Vec3> positions, velocities;
    std::shared_ptr<const std::vector<Join>> springs = nullptr;  ///< of a network
    double box = 0;                                              ///< side, of a liquid
};

/// Hand-written loops, Boost.odeint and, in double, GSL and SUNDIALS, as far as they have the method; each with the
/// plain and the gather force.
std::vector<Contestant> peers_in_double(const Problem& problem);
std::vector<Contestant> peers_in_float(const Problem& problem);

}  // namespace steplab::benchmark
