#pragma once

#include "core/instructions.hpp"
#include "core/precision.hpp"
#include "sim/run/run_description.hpp"

#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace steplab {

/// What a step waits for.
enum class Bound {
    latency,     ///< few particles: for the results of the step before
    arithmetic,  ///< for square roots, divisions, exponentials
    memory       ///< for positions and velocities that no cache holds
};
std::string_view text(Bound bound);

/// How fast a scene is stepped by one thread.
struct Speed {
    RunDescription run;
    std::size_t particles = 0;
    double seconds = 0;  ///< of a step
    Bound bound = Bound::arithmetic;
};

/// Tells what bounds each size of one model in one precision, small ones first, from how the time a particle changes.
/// Few particles are bound by latency where they take clearly longer, each, than in a larger size, or where there is no
/// other size; positions and velocities beyond the `cache` of a core, in bytes, are bound by memory where a particle
/// takes clearly longer than in a smaller size. All else is bound by arithmetic.
void find_bounds(std::span<Speed> sizes, std::size_t cache);

/// Times of a step of the same run, computed in several ways.
struct Comparison {
    RunDescription run;
    std::size_t particles = 0;
    std::vector<std::pair<std::string, double>> seconds;  ///< "avx2", or "2 threads"
};

/// How fast this machine is.
struct MachineSpeed {
    std::vector<Speed> scenes;  ///< every model, small and large, in both precisions
    Comparison instructions;    ///< one thread with each instruction set there is
    Comparison threads;         ///< 1, 2, 4, ... threads up to the processors of the machine
};

/// Measures steps of a method: the least time of several batches each. `watch` hears what part is done. Throws
/// UsageError if there is no such method.
MachineSpeed measure_machine(const std::string& method, const std::function<void(double)>& watch);

}  // namespace steplab
