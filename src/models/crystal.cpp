#include "core/number_text.hpp"
#include "models/model.hpp"
#include "models/parameters.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdint>
#include <string>

namespace steplab {

namespace {

constexpr ParameterInfo parameters[] = {particles_along_edge(6, 5, 20),
                                        start_spacing(1, 0.8, 2),
                                        particle_mass(50, 1000),
                                        well_depth(1),
                                        well_force_constant(50, 5, 500),
                                        well_distance(1, 0.5, 2),
                                        {.name = "cutoff",
                                         .unit = "m",
                                         .minimum = 0,
                                         .minimum_included = false,
                                         .default_value = 2,
                                         .what = "cut-off distance of the pair force, at most edge · spacing / 2.3",
                                         .slider_low = 1,
                                         .slider_high = 2.6},
                                        {.name = "jitter",
                                         .unit = "m",
                                         .minimum = 0,
                                         .default_value = 0.02,
                                         .on_change = OnChange::restarts,
                                         .what = "largest initial displacement from the lattice along each axis",
                                         .slider_low = 0,
                                         .slider_high = 0.1},
                                        {.name = "kT",
                                         .unit = "J",
                                         .minimum = 0,
                                         .default_value = 0.1,
                                         .on_change = OnChange::restarts,
                                         .what = "initial temperature: velocity components have the variance kT/m",
                                         .slider_low = 0,
                                         .slider_high = 1},
                                        {.name = "seed",
                                         .kind = ParameterInfo::Kind::integer,
                                         .unit = "",
                                         .minimum = 1,
                                         .maximum = 16777215,
                                         .default_value = 2008,
                                         .on_change = OnChange::restarts,
                                         .what = "seed of the random initial state",
                                         .slider_low = 1,
                                         .slider_high = 4000}};

/// The n-th random number of a seed, uniform in [0, 1): a counter, mixed as in SplitMix64 (Steele, Lea, Flood, OOPSLA
/// 2014).
double uniform(std::uint64_t seed, std::uint64_t n) {
    std::uint64_t z = (seed << 40) + (n + 1) * 0x9E3779B97F4A7C15;
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EB;
    return static_cast<double>((z ^ (z >> 31)) >> 11) * 0x1p-53;
}

/// A nearly normal random number of mean 0 and variance 1: the sum of twelve uniform ones, minus 6.
double nearly_normal(std::uint64_t seed, std::uint64_t n) {
    double sum = -6;
    for (std::uint64_t k = 0; k < 12; ++k) sum += uniform(seed, 12 * n + k);
    return sum;
}

/// Smaller indices are used for velocities.
constexpr std::uint64_t first_of_jitter = std::uint64_t(1) << 62;

/// The random initial state of a scene, particle by particle.
struct RandomStart {
    std::size_t edge;
    double spacing, jitter, speed;
    std::uint64_t seed;

    explicit RandomStart(const ParameterValues& values)
        : edge(values.count("edge")),
          spacing(values["spacing"]),
          jitter(values["jitter"]),
          speed(std::sqrt(values["kT"] / values["m"])),
          seed(values.count("seed")) {}

    std::size_t count() const { return edge * edge * edge; }

    /// x runs fastest, then y, then z.
    Vec3 position(std::size_t i) const {
        const auto along = [&](std::size_t index, std::uint64_t axis) {
            const double shift = 2 * uniform(seed, first_of_jitter + 3 * i + axis) - 1;
            return static_cast<double>(index) * spacing + jitter * shift;
        };
        return {along(i % edge, 0), along(i / edge % edge, 1), along(i / (edge * edge), 2)};
    }
    Vec3 velocity(std::size_t i) const {
        const auto along = [&](std::uint64_t axis) { return speed * nearly_normal(seed, 3 * i + axis); };
        return {along(0), along(1), along(2)};
    }
    Vec3 mean_velocity() const {
        Vec3 sum;
        for (std::size_t i = 0; i < count(); ++i) sum = sum + velocity(i);
        return 1 / static_cast<double>(count()) * sum;
    }
};

double period(const ParameterValues& values) { return values["edge"] * values["spacing"]; }

double particles(const ParameterValues& values) { return values["edge"] * values["edge"] * values["edge"]; }

std::optional<std::string> refusal(const ParameterValues& values) {
    const double least = 2.3 * values["cutoff"];  // pair lists extend 15 % further
    if (period(values) >= least) return std::nullopt;
    return fmt::format(
        "edge * spacing = {} is less than 2.3 times the cutoff, {}: a particle would interact with two images "
        "of another; choose a larger edge or a smaller cutoff",
        significant(period(values), 6), significant(least, 6));
}

Plan plan(const ParameterValues& values) {
    const RandomStart random(values);
    const std::size_t n = random.count();
    const NearPairForces forces{
        {n, values["m"], values["D"], values["k"], values["r0"]}, values["cutoff"], period(values)};
    const Start start(n, [random, mean = random.mean_velocity()](std::size_t i) {
        return Start::Particle{random.position(i), random.velocity(i) - mean};
    });
    return {.mass = values["m"], .forces = forces, .reference = {.count = n}, .start = start};
}

Shape shape(const ParameterValues& values) {
    const RandomStart random(values);
    Shape shape;
    shape.rest.reserve(random.count());
    for (std::size_t i = 0; i < random.count(); ++i) shape.rest.push_back(random.position(i));
    shape.roles.assign(random.count(), Role::moving);
    shape.spacing = values["spacing"];
    shape.period = period(values);
    const double half = values["spacing"] / 2, end = shape.period - half;
    shape.corner = {-half, -half, -half};
    shape.expected = {shape.corner, {end, end, end}};
    return shape;
}

}  // namespace

const Model& crystal_model() {
    static const Model model{
        .info =
            {.id = "crystal",
             .name = "Periodic crystal",
             .what =
                 "A periodic Morse crystal at finite temperature; it relaxes into a denser lattice, or melts if hot.",
             .parameters = parameters},
        .opening = {.method = "velocity-verlet", .dt = 0.05},
        .particles = particles,
        .facts =
            [](const ParameterValues& values) {
                return SceneFacts{.mass = values["m"],
                                  .bond = values["r0"],
                                  .pair_frequency = std::sqrt(2 * values["k"] / values["m"]),
                                  .lists_pairs = true};
            },
        .plan = plan,
        .shape = shape,
        .omega_max = [](const ParameterValues&) { return std::optional<double>(); },
        .exact = [](const ParameterValues&) { return std::shared_ptr<const ExactSolution>(); },
        .refusal = refusal,
    };
    return model;
}

}  // namespace steplab
