/// Runs the key kernels for valgrind --tool=callgrind, which writes a file of counts for each: named after it and the
/// number of steps counted. What comes before (the start, memory, caches) is not counted.

#include "sim/catalogue.hpp"
#include "sim/ensemble/ensemble.hpp"
#include "sim/run/simulation.hpp"

#include <fmt/format.h>

#include <string_view>
#include <utility>
#include <valgrind/callgrind.h>
#include <vector>

namespace steplab {
namespace {

const Execution by_baseline{.instructions = Instructions::baseline, .threads = 1};

struct Kernel {
    std::string_view name, model;
    std::vector<std::pair<std::string_view, double>> parameters;
    double dt;
    unsigned steps;  ///< few: valgrind takes a hundred times as long, and longer still to find the exact motion of a
                     ///< long chain
    std::vector<std::string_view> methods{"euler", "velocity-verlet", "rk4"};
};

const std::vector<Kernel>& kernels() {
    static const std::vector<Kernel> all{
        {"chain-10", "chain", {{"n", 10}}, 0.1, 512},
        {"chain-300", "chain", {{"n", 300}}, 0.1, 48},
        {"rope-10", "rope", {{"n", 10}}, 0.001, 512},
        {"rope-300", "rope", {{"n", 300}}, 0.001, 48},
        {"mesh-30x30", "mesh", {{"dim", 30}}, 0.1, 8},
        {"morse-28", "morse", {}, 0.01, 16},
        {"morse-cutoff", "morse", {{"edge", 5}, {"cutoff", 1}}, 0.01, 8},
        {"crystal-6", "crystal", {}, 0.01, 8, {"velocity-verlet"}},
        {"chain-10", "chain", {{"n", 10}}, 0.1, 256, {"srkn-11b", "gauss-16"}},
    };
    return all;
}

RunDescription run_of(const Kernel& kernel, std::string_view method, Precision precision) {
    RunDescription description = describe(kernel.model, method);
    for (const auto& [name, value] : kernel.parameters) description.scene.set(name, value);
    description.precision = precision;
    description.dt = kernel.dt;
    return description;
}

void count(const Kernel& kernel, std::string_view method, Precision precision) {
    Simulation simulation(run_of(kernel, method, precision), by_baseline);
    simulation.advance(1);
    const std::string name = fmt::format("{} {} {} {}", kernel.name, method, id(precision), kernel.steps);
    CALLGRIND_ZERO_STATS;
    simulation.advance(kernel.steps);
    CALLGRIND_DUMP_STATS_AT(name.c_str());
}

/// Runs that differ in k, side by side: instructions a run and step. Their start is counted too.
void count_ensemble(std::string_view method, Precision precision) {
    constexpr std::size_t runs = 64;
    constexpr unsigned steps = 8192;
    const Kernel kernel{"ensemble-10", "chain", {{"n", 10}}, 0.1, steps};
    std::vector<EnsembleRun> all(runs, {run_of(kernel, method, precision), {steps}});
    for (std::size_t i = 0; i < runs; ++i) all[i].description.scene.set("k", 1 + 0.01 * static_cast<double>(i));
    const std::string name = fmt::format("{} {} {} {}", kernel.name, method, id(precision), runs * steps);
    CALLGRIND_ZERO_STATS;
    run_ensemble(all, steps, by_baseline);
    CALLGRIND_DUMP_STATS_AT(name.c_str());
}

}  // namespace
}  // namespace steplab

int main() {
    using namespace steplab;
    for (const Precision precision : {Precision::double_, Precision::float_}) {
        for (const Kernel& kernel : kernels()) {
            for (const std::string_view method : kernel.methods) count(kernel, method, precision);
        }
        for (const std::string_view method : {"euler", "rk4"}) count_ensemble(method, precision);
    }
}
