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

/// What limits the speed of a step.
enum class Bound {
    latency,     ///< few particles: dependence on the results of the previous step
    arithmetic,  ///< square roots, divisions, exponentials
    memory       ///< positions and velocities that exceed the caches
};
std::string_view text(Bound bound);

/// The speed of a scene on one thread.
struct Speed {
    RunDescription run;
    std::size_t particles = 0;
    double seconds = 0;  ///< per step
    Bound bound = Bound::arithmetic;
};

/// Finds what limits each size of one model in one precision, in ascending order of size, from the time per particle.
/// Few particles are bound by latency if the time per particle is clearly larger than for a larger size, or if there is
/// no other size; positions and velocities beyond the `cache` of a core, in bytes, are bound by memory if the time per
/// particle is clearly larger than for a smaller size. Everything else is bound by arithmetic.
void find_bounds(std::span<Speed> sizes, std::size_t cache);

/// Times per step of the same run, executed in several ways.
struct Comparison {
    RunDescription run;
    std::size_t particles = 0;
    std::vector<std::pair<std::string, double>> seconds;  ///< "avx2", or "2 threads"
};

/// The speed of this machine.
struct MachineSpeed {
    std::vector<Speed> scenes;  ///< every model, small and large, in both precisions
    Comparison instructions;    ///< one thread, with each available instruction set
    Comparison threads;         ///< 1, 2, 4, ... threads up to the processors of the machine
};

/// How long to measure, in seconds.
struct MeasuringTime {
    double batch = 0.004;  ///< minimum duration of the steps between two readings of the clock
    double run = 0.25;     ///< duration of the batches of one run, at least one: enough for an undisturbed one
};

/// Measures the time per step of a method, the minimum over several batches. `watch` is called with the fraction that
/// is done. Throws UsageError if there is no such method.
MachineSpeed measure_machine(const std::string& method, const std::function<void(double)>& watch,
                             const MeasuringTime& time = {});

}  // namespace steplab
