#include "sim/run/memory.hpp"

#include "models/forces/neighbours.hpp"
#include "sim/catalogue.hpp"
#include "sim/run/starting.hpp"

#include <algorithm>
#include <fstream>
#include <numbers>
#include <string>
#include <unistd.h>
#include <variant>

namespace steplab {

namespace {

/// MemAvailable of /proc/meminfo in bytes, or all physical memory where there is no such line.
double system_memory() {
    std::ifstream info("/proc/meminfo");
    std::string name, unit;
    double kilobytes = 0;
    while (info >> name >> kilobytes) {
        if (name == "MemAvailable:") return kilobytes * 1024;
        std::getline(info, unit);
    }
    return static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGE_SIZE));
}

/// How many pairs act on each other in the scene as it starts.
double pairs(const ConstantForces&, const Plan&) { return 0; }
double pairs(const LineForces& forces, const Plan&) { return static_cast<double>(forces.count); }
double pairs(const GridForces& forces, const Plan&) { return 4.0 * static_cast<double>(forces.rows * forces.columns); }
double pairs(const PairForces& forces, const Plan&) {
    return static_cast<double>(forces.count) * static_cast<double>(forces.count) / 2;
}
double pairs(const NearPairForces& forces, const Plan& scene) {
    Neighbours neighbours(forces.cutoff, forces.period);
    neighbours.follow(scene.start.state().displacement);
    double sum = 0;
    for (std::size_t i = 0; i < forces.count; ++i) sum += static_cast<double>(neighbours.of(i).size());
    return sum / 2;
}
double pairs(const ComposedForces& forces, const Plan&) {
    const Composition& terms = *forces.terms;
    double sum = static_cast<double>(terms.springs.size());
    for (const ComposedPairs& set : terms.pairs) {
        const double first = static_cast<double>(set.first.size()), second = static_cast<double>(set.second.size());
        sum += set.second.empty() ? first * first / 2 : first * second;
    }
    return sum;
}

/// Of space, as the particles of a scene are at the start.
double volume(const NearPairForces& forces, const Plan& scene) {
    if (forces.period > 0) return forces.period * forces.period * forces.period;
    Vec3 low = scene.start[0].displacement, high = low;
    for (std::size_t i = 1; i < forces.count; ++i) {
        const Vec3 at = scene.start[i].displacement;
        low = {std::min(low.x, at.x), std::min(low.y, at.y), std::min(low.z, at.z)};
        high = {std::max(high.x, at.x), std::max(high.y, at.y), std::max(high.z, at.z)};
    }
    return (high.x - low.x) * (high.y - low.y) * (high.z - low.z);
}

/// Lists of clusters (cluster_lists.hpp): of four particles one list, of numbers of four bytes, that holds about as
/// many as one of them has within reach, as many again reserved; and what is held for each particle while lists are
/// made.
double bytes_of_lists(const NearPairForces& forces, const Plan& scene) {
    const double particles = static_cast<double>(forces.count), reach = 1.15 * forces.cutoff;
    const double sphere = 4 * std::numbers::pi / 3 * reach * reach * reach;
    const double within_reach = std::min(particles, particles / volume(forces, scene) * sphere);
    return particles * (2 * within_reach + 350);
}

}  // namespace

double available_memory() { return std::max(0.0, 0.9 * system_memory()); }

double bytes_per_particle(const RunDescription& description) {
    const double number = description.precision == Precision::float_ ? 4 : 8, vector = 3 * number;
    const Method& entry = method(description.method);
    const double seen = 2 * 3 * 8.0, frame = 2 * 3 * 8.0;  // in double, whatever the precision
    const double shape = 3 * 8.0 + 1 + 4 * 16.0;           // a particle has up to 4 springs of its own
    const double shown = seen + frame + shape;
    const bool own_steps = description.method_parameters.contains("tolerance");
    if (entry.info.curiosity) return 8 * vector + 4 * 3 * 8.0 + 2 * seen + shown;  // it lists its springs
    if (!own_steps && !entry.info.bytes_of_interactions) {
        // position and velocity, what a stage of Runge-Kutta methods adds, what rounding cuts off, a state to come back
        // to
        const double fields = 2 + (entry.info.evaluations > 1 ? 4 : 0) + 2 + 4;
        return fields * vector + shown;
    }
    // With steps of its own it holds both ends of the last one in two parts, and stages or terms of it, all of them
    // once more in the state to come back to.
    const double stages = std::min(entry.info.evaluations, 20), fields = own_steps ? 20 + 4 * stages : 3 + 2 * stages;
    return (fields + 3) * vector + 2 * seen + shown;
}

double bytes_of_run(const RunDescription& description) {
    const Model& entry = model_of(description);
    return entry.particles(description.scene) * bytes_per_particle(description) +
           bytes_of_interactions(description, plan_of(description));
}

double interacting_pairs(const Plan& scene) {
    return std::visit([&](const auto& forces) { return pairs(forces, scene); }, scene.forces);
}

double bytes_of_interactions(const RunDescription& description, const Plan& scene) {
    const Method& entry = method(description.method);
    const auto* const near = std::get_if<NearPairForces>(&scene.forces);
    const double lists = near ? bytes_of_lists(*near, scene) : 0;
    if (!entry.info.bytes_of_interactions) return lists;
    return lists + std::visit(
                       [&](const auto& forces) {
                           return entry.info.bytes_of_interactions(coupling(forces), pairs(forces, scene));
                       },
                       scene.forces);
}

}  // namespace steplab
