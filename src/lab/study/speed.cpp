#include "lab/study/speed.hpp"

#include "core/team.hpp"
#include "sim/catalogue.hpp"
#include "sim/run/simulation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <limits>
#include <span>
#include <string_view>
#include <unistd.h>

namespace steplab {

namespace {

/// Sizes of a model: the first is small, the second fits into the second-level cache, the last does not fit into any
/// cache.
struct Sizes {
    std::string_view model, parameter;
    std::vector<double> values;
};

const std::vector<Sizes>& sizes() {
    static const std::vector<Sizes> all{{"free", "n", {10, 1000, 1e6}},       {"oscillator", "k", {1}},
                                        {"chain", "n", {10, 1000, 1e5, 1e6}}, {"rope", "n", {10, 1000, 1e6}},
                                        {"mesh", "dim", {10, 32, 100, 1000}}, {"morse", "edge", {3, 8}},
                                        {"crystal", "edge", {6, 16, 40}}};
    return all;
}

RunDescription run_of(const Sizes& sizes, double value, const std::string& method, Precision precision) {
    RunDescription run = describe(sizes.model, method);
    run.scene.set(sizes.parameter, value);
    run.precision = precision;
    run.dt = 0.001;  // small enough that no scene diverges
    return run;
}

double seconds_of(Simulation& simulation, std::uint64_t steps) {
    const auto begin = std::chrono::steady_clock::now();
    simulation.advance(steps);
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

double seconds_a_step(const RunDescription& run, const Execution& execution, const MeasuringTime& time) {
    Simulation simulation(run, execution);
    std::uint64_t steps = 1;
    while (seconds_of(simulation, steps) < time.batch) steps *= 2;
    double least = std::numeric_limits<double>::infinity(), spent = 0;
    do {
        const double seconds = seconds_of(simulation, steps);
        spent += seconds;
        least = std::min(least, seconds / static_cast<double>(steps));
    } while (spent < time.run);
    return least;
}

double seconds_a_particle(const Speed& speed) { return speed.seconds / static_cast<double>(speed.particles); }

/// The smallest time per particle among some sizes; infinite if there are none.
double least_a_particle(std::span<const Speed> sizes) {
    double least = std::numeric_limits<double>::infinity();
    for (const Speed& size : sizes) least = std::min(least, seconds_a_particle(size));
    return least;
}

/// Size of the second-level cache of a core; if the system does not report it, the smallest in current processors.
std::size_t bytes_of_second_cache() {
    const long bytes = sysconf(_SC_LEVEL2_CACHE_SIZE);
    return bytes > 0 ? static_cast<std::size_t>(bytes) : std::size_t{256} << 10;
}

Comparison compared(const RunDescription& run) {
    return {.run = run, .particles = static_cast<std::size_t>(model_of(run).particles(run.scene)), .seconds = {}};
}

}  // namespace

void find_bounds(std::span<Speed> sizes, std::size_t cache) {
    constexpr double clearly = 1.25;  // other load of the machine changes times by 10 to 20 %
    constexpr std::size_t few = 100;  // a dozen wide registers: too few to hide the latency of a root
    for (std::size_t i = 0; i < sizes.size(); ++i) {
        Speed& size = sizes[i];
        const double each = seconds_a_particle(size);
        const std::size_t bytes = 6 * size.particles * (size.run.precision == Precision::double_ ? 8 : 4);
        const bool alone = sizes.size() == 1;
        if (size.particles <= few && (alone || each > clearly * least_a_particle(sizes.subspan(i + 1))))
            size.bound = Bound::latency;
        else if (bytes > cache && each > clearly * least_a_particle(sizes.first(i)))
            size.bound = Bound::memory;
        else
            size.bound = Bound::arithmetic;
    }
}

std::string_view text(Bound bound) {
    constexpr std::array<std::string_view, 3> texts{"latency", "arithmetic", "memory"};
    return texts[static_cast<std::size_t>(bound)];
}

MachineSpeed measure_machine(const std::string& method, const std::function<void(double)>& watch,
                             const MeasuringTime& time) {
    MachineSpeed speed;
    std::size_t count = 0, done = 0;
    for (const Sizes& model : sizes()) count += 2 * model.values.size();
    for (const Sizes& model : sizes()) {
        for (const Precision precision : {Precision::double_, Precision::float_}) {
            const std::size_t first = speed.scenes.size();
            for (const double value : model.values) {
                const RunDescription run = run_of(model, value, method, precision);
                watch(static_cast<double>(done++) / static_cast<double>(count));
                speed.scenes.push_back({.run = run,
                                        .particles = compared(run).particles,
                                        .seconds = seconds_a_step(run, {.threads = 1}, time)});
            }
            find_bounds(std::span(speed.scenes).subspan(first), bytes_of_second_cache());
        }
    }
    RunDescription mesh = describe("mesh", method);
    mesh.dt = 0.001;
    mesh.scene.set("dim", 100);
    speed.instructions = compared(mesh);
    for (const Instructions instructions : instructions_here())
        speed.instructions.seconds.emplace_back(
            id(instructions), seconds_a_step(mesh, {.instructions = instructions, .threads = 1}, time));
    mesh.scene.set("dim", 1000);
    speed.threads = compared(mesh);
    for (std::size_t threads = 1; threads <= processors(); threads *= 2)
        speed.threads.seconds.emplace_back(fmt::format("{} thread{}", threads, threads > 1 ? "s" : ""),
                                           seconds_a_step(mesh, {.threads = threads}, time));
    return speed;
}

}  // namespace steplab
