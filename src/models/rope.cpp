#include "models/chain_modes.hpp"
#include "models/line_plan.hpp"
#include "models/parameters.hpp"
#include "models/scene/parameter.hpp"

namespace steplab {

namespace {

constexpr ParameterInfo parameters[] = {number_of_particles(2, 10),
                                        rest_length(0.5),
                                        force_constant(200, "1/s²", 2000),
                                        drag(0.3),
                                        {.name = "g",
                                         .unit = "m/s²",
                                         .minimum = 0,
                                         .default_value = 9.81,
                                         .what = "gravitational acceleration, along -y",
                                         .slider_low = 0,
                                         .slider_high = 30},
                                        particle_mass(0.3)};

/// The springs' force constant is k m, so that the shape of the hanging rope does not depend on its mass.
Scene scene(const ParameterValues& values) {
    Scene scene;
    scene.particles = {{.group = "rope",
                        .mass = parameter(values, "m"),
                        .arrangement = LineArrangement{values.count("n"), {parameter(values, "L"), 0, 0}}}};
    scene.fixes = {{.particles = {"rope[0]"}, .fixed = true}};
    scene.springs = {{.between = "rope", .k = parameter(values, "k") * parameter(values, "m")}};
    scene.fields = {{.gravity = WrittenVector{0, -parameter(values, "g"), 0}, .drag = parameter(values, "c")}};
    return scene;
}

LineForces forces(const ParameterValues& values) {
    return {.count = values.count("n"),
            .first_fixed = true,
            .mass = values["m"],
            .k = values["k"] * values["m"],
            .rest_length = values["L"],
            .gravity = values["g"]};
}

Plan plan(const ParameterValues& values) { return line_plan(forces(values), values["c"] / values["m"]); }

/// The distance of the end below the fixed particle at rest: (n - 1) L + (g / k) n (n - 1) / 2.
double hanging_length(const ParameterValues& values) {
    const double n = values["n"];
    return (n - 1) * values["L"] + values["g"] / values["k"] * n * (n - 1) / 2;
}

Shape shape(const ParameterValues& values) {
    Shape shape = line_shape(values.count("n"), values["L"], true);
    // While falling, it stretches beyond its length at rest, and swings a little to the other side.
    const double hanging = hanging_length(values);
    shape.expected = {{0, -1.15 * hanging, 0}, {-0.2 * hanging, -hanging, 0}};
    return shape;
}

/// Link j = 1 .. n-1 from the anchor carries n - j particles and is stretched by (n - j) g / k.
Field<double> resting(const ParameterValues& values) {
    const double n = values["n"];
    Field<double> displacement(values.count("n"));
    for (std::size_t particle = 1; particle < values.count("n"); ++particle) {
        const double i = static_cast<double>(particle), carried = i * n - i * (i + 1) / 2;
        const double length = i * values["L"] + values["g"] / values["k"] * carried;
        displacement.set(particle, {-i * values["L"], -length, 0});
    }
    return displacement;
}

}  // namespace

const Model& rope_model() {
    static const Model model{
        .info = {.id = "rope",
                 .name = "Rope",
                 .what = "Particles connected by stiff springs, the first one fixed; the rope starts horizontal, falls "
                         "and swings with drag.",
                 .parameters = parameters},
        .opening = {.method = "rk4", .dt = 0.02},
        .topic = "springs",
        .particles = [](const ParameterValues& values) { return values["n"]; },
        .facts = [](const ParameterValues& values) { return line_facts(forces(values), values["c"] / values["m"]); },
        .scene = scene,
        .plan = plan,
        .shape = shape,
        .omega_max =
            [](const ParameterValues& values) {
                return std::optional(
                    ChainModes{.count = values.count("n"), .k_over_m = values["k"]}.highest_frequency());
            },
        .exact = [](const ParameterValues&) { return std::shared_ptr<const ExactSolution>(); },
        .resting = resting,
    };
    return model;
}

}  // namespace steplab
