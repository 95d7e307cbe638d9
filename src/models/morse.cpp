#include "models/head_on.hpp"
#include "models/model.hpp"
#include "models/parameters.hpp"
#include "models/scene/morse_term.hpp"
#include "models/scene/parameter.hpp"

namespace steplab {

namespace {

constexpr ParameterInfo parameters[] = {well_depth(1),
                                        well_force_constant(0.5, 0.05, 10),
                                        well_distance(0.5, 0.1, 3),
                                        start_spacing(0.5, 0.1, 3),
                                        particle_mass(1),
                                        kick_speed(1, "initial velocity of the bullet, along x"),
                                        particles_along_edge(3, 1, 10),
                                        {.name = "cutoff",
                                         .unit = "m",
                                         .minimum = 0,
                                         .default_value = 0,
                                         .what = "cut-off distance of the pair force; 0: no cut-off",
                                         .slider_low = 0,
                                         .slider_high = 5}};

constexpr Vec3 bullet_start{-10, 0, 0};

std::size_t count(const ParameterValues& values) {
    const std::size_t edge = values.count("edge");
    return edge * edge * edge + 1;
}

/// The cube's particles with x running fastest, then y, then z; the bullet is the last particle.
Vec3 start_position(const ParameterValues& values, std::size_t particle) {
    const std::size_t edge = values.count("edge");
    if (particle == edge * edge * edge) return bullet_start;
    const auto along = [&](std::size_t index) { return static_cast<double>(index) * values["spacing"]; };
    return {along(particle % edge), along(particle / edge % edge), along(particle / (edge * edge))};
}

Forces forces(const ParameterValues& values) {
    const PairForces pairs{count(values), values["m"], values["D"], values["k"], values["r0"]};
    if (values["cutoff"] > 0) return NearPairForces{pairs, values["cutoff"]};
    return pairs;
}

Scene scene(const ParameterValues& values) {
    const std::size_t edge = values.count("edge");
    const WrittenNumber mass = parameter(values, "m");
    Scene scene;
    scene.particles = {
        {.group = "cluster",
         .mass = mass,
         .arrangement = CrystalArrangement{.cells = {edge, edge, edge}, .constant = parameter(values, "spacing")}},
        {.group = "bullet",
         .position = {bullet_start.x, bullet_start.y, bullet_start.z},
         .velocity = {parameter(values, "v0"), 0, 0},
         .mass = mass,
         .role = Role::bullet}};
    scene.pairs = {morse_term(values)};
    if (values["cutoff"] > 0) scene.pairs.front().cutoff = parameter(values, "cutoff");
    return scene;
}

Plan plan(const ParameterValues& values) {
    const std::size_t n = count(values);
    State<double> start{Field<double>(n), Field<double>(n)};
    for (std::size_t i = 0; i < n; ++i) start.displacement.set(i, start_position(values, i));
    start.velocity.set(n - 1, {values["v0"], 0, 0});
    return {.mass = values["m"], .forces = forces(values), .reference = {.count = n}, .start = std::move(start)};
}

Shape shape(const ParameterValues& values) {
    const std::size_t n = count(values);
    Shape shape;
    for (std::size_t i = 0; i < n; ++i) shape.rest.push_back(start_position(values, i));
    shape.roles.assign(n, Role::moving);
    shape.roles.back() = Role::bullet;
    shape.spacing = values["spacing"];
    return shape;
}

/// One particle and the bullet, head on.
std::shared_ptr<const ExactSolution> exact(const ParameterValues& values) {
    if (values["edge"] != 1 || values["cutoff"] > 0) return nullptr;
    const PairForces pair{2, values["m"], values["D"], values["k"], values["r0"]};
    return head_on_solution(pair, bullet_start.x, values["v0"]);
}

double particles(const ParameterValues& values) { return values["edge"] * values["edge"] * values["edge"] + 1; }

}  // namespace

const Model& morse_model() {
    static const Model model{
        .info = {.id = "morse",
                 .name = "Morse cluster",
                 .what = "A cube of particles that interact by the Morse potential, and a bullet shot at it.",
                 .parameters = parameters},
        .opening = {.method = "rk4", .dt = 0.01},
        .topic = "molecules",
        .particles = particles,
        .facts =
            [](const ParameterValues& values) {
                return SceneFacts{.mass = values["m"],
                                  .bond = values["r0"],
                                  .bond_width = std::sqrt(2 * values["D"] / values["k"]),
                                  .pair_frequency = std::sqrt(2 * values["k"] / values["m"]),
                                  .lists_pairs = values["cutoff"] > 0};
            },
        .scene = scene,
        .plan = plan,
        .shape = shape,
        .omega_max = [](const ParameterValues&) { return std::optional<double>(); },
        .exact = exact,
    };
    return model;
}

}  // namespace steplab
