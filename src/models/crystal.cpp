#include "core/number_text.hpp"
#include "models/model.hpp"
#include "models/parameters.hpp"
#include "models/scene/morse_term.hpp"
#include "models/scene/parameter.hpp"
#include "models/scene/random_start.hpp"

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

/// The random initial state of a scene, particle by particle.
struct RandomStart {
    std::size_t edge;
    double spacing;
    RandomDisplacement jitter;
    ThermalVelocities velocities;

    explicit RandomStart(const ParameterValues& values)
        : edge(values.count("edge")),
          spacing(values["spacing"]),
          jitter{values["jitter"], values.count("seed")},
          velocities({values["kT"], values.count("seed"), false}, values["m"], count()) {}

    std::size_t count() const { return edge * edge * edge; }

    /// x runs fastest, then y, then z.
    Vec3 position(std::size_t i) const {
        const auto along = [&](std::size_t index) { return static_cast<double>(index) * spacing; };
        const Vec3 place{along(i % edge), along(i / edge % edge), along(i / (edge * edge))};
        return place + random_displacement(jitter, i);
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

Scene scene(const ParameterValues& values) {
    const std::size_t edge = values.count("edge");
    const WrittenNumber spacing = parameter(values, "spacing"), side = WrittenNumber(values["edge"]) * spacing;
    Scene scene;
    scene.particles = {{.group = "crystal",
                        .mass = parameter(values, "m"),
                        .arrangement = CrystalArrangement{.cells = {edge, edge, edge}, .constant = spacing},
                        .displacement = RandomDisplacement{parameter(values, "jitter"), values.count("seed")},
                        .temperature = Temperature{parameter(values, "kT"), values.count("seed"), false}}};
    scene.pairs = {morse_term(values)};
    scene.pairs.front().cutoff = parameter(values, "cutoff");
    scene.box = {side, side, side};
    const WrittenNumber corner = WrittenNumber(-0.5) * spacing;
    scene.corner = WrittenVector{corner, corner, corner};
    return scene;
}

Plan plan(const ParameterValues& values) {
    const RandomStart random(values);
    const std::size_t n = random.count();
    const NearPairForces forces{
        {n, values["m"], values["D"], values["k"], values["r0"]}, values["cutoff"], period(values)};
    const Start start(n, [random](std::size_t i) { return Start::Particle{random.position(i), random.velocities[i]}; });
    return {.mass = values["m"], .forces = forces, .reference = {.count = n}, .start = start};
}

Shape shape(const ParameterValues& values) {
    const RandomStart random(values);
    Shape shape;
    shape.rest.reserve(random.count());
    for (std::size_t i = 0; i < random.count(); ++i) shape.rest.push_back(random.position(i));
    shape.roles.assign(random.count(), Role::moving);
    shape.spacing = values["spacing"];
    const double side = period(values), half = values["spacing"] / 2, end = side - half;
    shape.box = {side, side, side};
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
                 "A cubic Morse crystal in a periodic box; its lattice gives way, and the energy set free melts it.",
             .parameters = parameters},
        .opening = {.method = "velocity-verlet", .dt = 0.05},
        .topic = "molecules",
        .particles = particles,
        .facts =
            [](const ParameterValues& values) {
                return SceneFacts{.mass = values["m"],
                                  .bond = values["r0"],
                                  .bond_width = std::sqrt(2 * values["D"] / values["k"]),
                                  .pair_frequency = std::sqrt(2 * values["k"] / values["m"]),
                                  .lists_pairs = true};
            },
        .scene = scene,
        .plan = plan,
        .shape = shape,
        .omega_max = [](const ParameterValues&) { return std::optional<double>(); },
        .exact = [](const ParameterValues&) { return std::shared_ptr<const ExactSolution>(); },
        .refusal = refusal,
    };
    return model;
}

}  // namespace steplab
