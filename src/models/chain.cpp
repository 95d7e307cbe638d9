#include "models/chain_modes.hpp"
#include "models/line_plan.hpp"
#include "models/parameters.hpp"
#include "models/scene/parameter.hpp"

#include <cmath>

namespace steplab {

namespace {

constexpr ParameterInfo parameters[] = {number_of_particles(2, 10),
                                        rest_length(2),
                                        force_constant(1, "N/m", 100),
                                        particle_mass(1),
                                        drag(0),
                                        {.name = "fixed",
                                         .kind = ParameterInfo::Kind::integer,
                                         .unit = "",
                                         .minimum = 0,
                                         .maximum = 1,
                                         .default_value = 1,
                                         .on_change = OnChange::restarts,
                                         .what = "1: particle 0 is fixed, 0: all particles move",
                                         .slider_high = 1},
                                        kick_speed(2, "initial velocity of the last particle, along x")};

/// The exact solution is a sum over all modes for each particle: with more particles it takes too long to be of use.
constexpr std::size_t most_exact = 1024;

ChainModes modes(const ParameterValues& values) {
    const long double mass = values["m"];
    return {values.count("n"), values["fixed"] != 0, values["k"] / mass, values["c"] / mass};
}

Scene scene(const ParameterValues& values) {
    Scene scene;
    scene.particles = {{.group = "chain",
                        .mass = parameter(values, "m"),
                        .arrangement = LineArrangement{values.count("n"), {parameter(values, "L"), 0, 0}}}};
    if (values["fixed"] != 0) scene.fixes.push_back({.particles = {"chain[0]"}, .fixed = true});
    scene.fixes.push_back(
        {.particles = {"chain[-1]"}, .velocity = WrittenVector{parameter(values, "v0"), 0, 0}, .role = Role::kicked});
    scene.springs = {{.between = "chain", .k = parameter(values, "k")}};
    scene.fields = {{.drag = parameter(values, "c")}};
    return scene;
}

LineForces forces(const ParameterValues& values) {
    return {.count = values.count("n"),
            .first_fixed = values["fixed"] != 0,
            .mass = values["m"],
            .k = values["k"],
            .rest_length = values["L"]};
}

Plan plan(const ParameterValues& values) {
    return line_plan(forces(values), values["c"] / values["m"], {values["v0"], 0, 0});
}

Shape shape(const ParameterValues& values) {
    Shape shape = line_shape(values.count("n"), values["L"], values["fixed"] != 0);
    shape.roles.back() = Role::kicked;
    const Vec3 amplitude{values["v0"] * std::sqrt(values["m"] / values["k"]), 0, 0};
    shape.expected = {shape.rest.back() + amplitude, shape.rest.back() - amplitude};
    return shape;
}

/// Neighbours cannot pass each other if the energy of the kick is too small to compress one spring to length 0; with L
/// = 0 the springs are linear in every orientation.
std::shared_ptr<const ExactSolution> exact(const ParameterValues& values) {
    const bool linear =
        values["L"] == 0 || std::abs(values["v0"]) * std::sqrt(values["m"] / values["k"]) <= values["L"];
    if (!linear || values.count("n") > most_exact) return nullptr;
    return chain_solution(modes(values), values["v0"]);
}

}  // namespace

const Model& chain_model() {
    static const Model model{
        .info = {.id = "chain",
                 .name = "Spring chain",
                 .what = "Particles in a line, each connected to its neighbours by springs; the last one is kicked "
                         "along the line.",
                 .parameters = parameters},
        .topic = "springs",
        .particles = [](const ParameterValues& values) { return values["n"]; },
        .facts = [](const ParameterValues& values) { return line_facts(forces(values), values["c"] / values["m"]); },
        .scene = scene,
        .plan = plan,
        .shape = shape,
        .omega_max = [](const ParameterValues& values) { return std::optional(modes(values).highest_frequency()); },
        .exact = exact,
    };
    return model;
}

}  // namespace steplab
