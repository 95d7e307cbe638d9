/// Runs the key kernels for valgrind --tool=callgrind, which writes a file of counts for each: named after it and the
/// number of steps counted. What comes before (the start, memory, caches) is not counted.

#include "sim/catalogue.hpp"
#include "sim/simulation.hpp"

#include <fmt/format.h>

#include <string_view>
#include <utility>
#include <valgrind/callgrind.h>
#include <vector>

namespace steplab {
namespace {

struct Kernel {
    std::string_view name, model;
    std::vector<std::pair<std::string_view, double>> parameters;
    double dt;
    unsigned steps;  ///< few: valgrind takes a hundred times as long, and longer still to find the exact motion of a
                     ///< long chain
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
    };
    return all;
}

void count(const Kernel& kernel, std::string_view method, Precision precision) {
    RunDescription description = describe(kernel.model, method);
    for (const auto& [name, value] : kernel.parameters) description.scene.set(name, value);
    description.precision = precision;
    description.dt = kernel.dt;
    Simulation simulation(description);
    simulation.advance(1);
    const std::string name = fmt::format("{} {} {} {}", kernel.name, method, id(precision), kernel.steps);
    CALLGRIND_ZERO_STATS;
    simulation.advance(kernel.steps);
    CALLGRIND_DUMP_STATS_AT(name.c_str());
}

}  // namespace
}  // namespace steplab

int main() {
    using namespace steplab;
    for (const Kernel& kernel : kernels()) {
        for (const Method& method : methods()) {
            for (const Precision precision : {Precision::double_, Precision::float_})
                count(kernel, method.info.id, precision);
        }
    }
}
