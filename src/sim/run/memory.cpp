#include "sim/run/memory.hpp"

#include "models/forces/composed_formula.hpp"
#include "models/forces/composed_pairs.hpp"
#include "models/forces/neighbours.hpp"
#include "sim/catalogue.hpp"
#include "sim/run/starting.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <memory>
#include <numbers>
#include <string>
#include <unistd.h>
#include <variant>
#include <vector>

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

/// The other particles within a distance of one at the start, on average: from how many share a cell of that side, in
/// some of the cells.
double partners_within(double distance, const Plan& scene) {
    constexpr std::size_t enough = 50'000;
    const std::size_t count = scene.start.count(), every = std::max<std::size_t>(1, count / enough);
    const auto cell_of = [distance](double x) {
        return static_cast<std::uint64_t>(static_cast<std::int64_t>(std::floor(std::clamp(x / distance, -1e15, 1e15))));
    };
    std::vector<std::uint64_t> cells;
    for (std::size_t i = 0; i < count; ++i) {
        const Vec3 at = scene.reference.at(i) + scene.start[i].displacement;
        // odd constants of which each bit of the product depends on all bits below
        const std::uint64_t cell = (cell_of(at.x) * 0x9e3779b97f4a7c15 ^ cell_of(at.y)) * 0xbf58476d1ce4e5b9 ^
                                   (cell_of(at.z) * 0x94d049bb133111eb);
        if ((cell >> 32) % every == 0) cells.push_back(cell);
    }
    std::sort(cells.begin(), cells.end());
    double sharing = 0;
    for (auto first = cells.begin(); first != cells.end();) {
        const auto next = std::upper_bound(first, cells.end(), *first);
        const auto together = static_cast<double>(next - first);
        sharing += together * (together - 1);
        first = next;
    }
    constexpr double sphere = 4 * std::numbers::pi / 3;  // of a cell
    return cells.empty() ? 0 : sphere * sharing / static_cast<double>(cells.size());
}

double pairs(const ComposedForces& forces, const Plan& scene) {
    const Composition& terms = *forces.terms;
    double sum = static_cast<double>(terms.springs.size());
    for (const ComposedPairs& set : terms.pairs) {
        const double first = static_cast<double>(set.first.size()), second = static_cast<double>(set.second.size());
        if (!set.listed.empty()) {
            sum += static_cast<double>(set.listed.size());
            continue;
        }
        const double all = set.second.empty() ? first * first / 2 : first * second;
        const double near = set.cutoff > 0 ? partners_within(set.cutoff, scene) / static_cast<double>(terms.count) : 1;
        sum += all * std::min(1.0, near);
    }
    return sum;
}

/// The springs of a scene where nothing else acts between particles, whatever their law, unless there are so many
/// particles that no linear system of them is solved.
std::vector<std::array<std::uint32_t, 2>> bonds_of(const ComposedForces& forces) {
    constexpr std::size_t most = 20'000;
    const Composition& terms = *forces.terms;
    std::vector<std::array<std::uint32_t, 2>> bonds;
    const bool all_listed = std::all_of(terms.pairs.begin(), terms.pairs.end(),
                                        [](const ComposedPairs& set) { return !set.listed.empty(); });
    if (!all_listed || terms.count > most) return bonds;
    for (const ComposedSpring& spring : terms.springs) bonds.push_back({spring.first, spring.second});
    for (const ComposedPairs& set : terms.pairs) bonds.insert(bonds.end(), set.listed.begin(), set.listed.end());
    return bonds;
}
template <class Other>
std::vector<std::array<std::uint32_t, 2>> bonds_of(const Other&) {
    return {};
}

/// Lists reach beyond the cut-off by a skin.
constexpr double reach = 1.15;

/// Lists of clusters (cluster_lists.hpp): of four particles one list, of numbers of four bytes, that holds about as
/// many as one of them has within reach, as many again reserved; and what is held for each particle while lists are
/// made.
double bytes_of_clusters(double particles, double within_reach) {
    return particles * (2 * std::min(particles, within_reach) + 350);
}

/// Lists of neighbours: each pair in both, of the stepper and, while it is measured, of the energy.
double bytes_of_neighbours(double particles, double within_reach) {
    return particles * (7 * std::min(particles, within_reach) + 100);
}

/// Of a vector that grows by doubling.
double grown(std::size_t count) { return static_cast<double>(std::bit_ceil(count)); }

/// Springs with a potential: in the scene, and in the engines of the stepper and of the energy.
double bytes_of_set(const ComposedPairs& set, const Composition& terms, const Plan& scene) {
    const auto particles = static_cast<double>(terms.count);
    if (!set.listed.empty()) return 3 * sizeof(set.listed.front()) * grown(set.listed.size());
    if (set.cutoff == 0) return 60 * particles;  // masses and charges of rows
    const double within_reach = partners_within(reach * set.cutoff, scene);
    PairForce<double> engine(set, terms, std::make_shared<Team>(1));
    return engine.clusters() ? bytes_of_clusters(particles, within_reach)
                             : bytes_of_neighbours(particles, within_reach);
}

/// Springs of the scene, once more in the order in which they are stepped; their formulas in the engines of the stepper
/// and of the energy, rows of both ends, and what is held while these are made.
double bytes_of_springs(const std::vector<ComposedSpring>& springs) {
    constexpr double row = 4 + 2 * 8.0, made = 64;  // row: the other end, numbers that differ
    const auto count = static_cast<double>(springs.size()), most = grown(springs.size());
    return sizeof(ComposedSpring) * (most + count) + 2 * (sizeof(ComposedFormula<double>) * most + row * 2 * most) +
           made * count;
}

/// Their formulas and numbers in lanes, of a method that evaluates all its stages at once.
double bytes_in_stages(const std::vector<ComposedSpring>& springs) {
    constexpr double numbers = 8, lanes = 8;
    return (lanes * sizeof(ComposedFormula<double>) + lanes * numbers * 8 + 8) * grown(springs.size());
}

/// What is held for forces beside what a method holds for them.
double bytes_held(const NearPairForces& forces, const Plan& scene) {
    return bytes_of_clusters(static_cast<double>(forces.count), partners_within(reach * forces.cutoff, scene));
}
double bytes_held(const ComposedForces& forces, const Plan& scene) {
    const Composition& terms = *forces.terms;
    // masses, charges, what is fixed; references of the scene, the engines and their rows
    const double of_particle = 60 + (terms.reference.empty() ? 0 : 300);
    double bytes = of_particle * static_cast<double>(terms.count);
    if (!terms.springs.empty()) bytes += bytes_of_springs(terms.springs);
    for (const ComposedPairs& set : terms.pairs) bytes += bytes_of_set(set, terms, scene);
    return bytes;
}
template <class Other>
double bytes_held(const Other&, const Plan&) {
    return 0;
}

double bytes_in_stages(const Plan& scene) {
    const auto* const forces = std::get_if<ComposedForces>(&scene.forces);
    return forces && !forces->terms->springs.empty() ? bytes_in_stages(forces->terms->springs) : 0;
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
    const double held = std::visit([&](const auto& forces) { return bytes_held(forces, scene); }, scene.forces);
    if (!entry.info.bytes_of_interactions) return held + (entry.info.implicit ? bytes_in_stages(scene) : 0);
    return held + std::visit(
                      [&](const auto& forces) {
                          const auto bonds = bonds_of(forces);
                          return entry.info.bytes_of_interactions(coupling(forces), {pairs(forces, scene), bonds});
                      },
                      scene.forces);
}

}  // namespace steplab
