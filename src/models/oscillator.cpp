#include "models/forces/linear_response.hpp"
#include "models/line_plan.hpp"
#include "models/parameters.hpp"
#include "models/scene/parameter.hpp"

#include <cmath>

namespace steplab {

namespace {

constexpr ParameterInfo parameters[] = {particle_mass(1), force_constant(1, "N/m", 100), drag(0),
                                        kick_speed(1, "initial velocity of the particle, along x")};

double omega(const ParameterValues& values) { return std::sqrt(values["k"] / values["m"]); }

class Solution final : public ExactSolution {
public:
    explicit Solution(const ParameterValues& values)
        : omega2_(static_cast<long double>(values["k"]) / values["m"]),
          gamma_(static_cast<long double>(values["c"]) / values["m"]),
          v0_(values["v0"]) {}

    Vec3 displacement(std::size_t particle, double t) const override {
        if (particle == 0) return {};
        return {static_cast<double>(v0_ * KickResponse(omega2_, gamma_, t).g), 0, 0};
    }

    Vec3 velocity(std::size_t particle, double t) const override {
        if (particle == 0) return {};
        return {static_cast<double>(v0_ * KickResponse(omega2_, gamma_, t).g_rate), 0, 0};
    }

    double rounding(double t) const override { return mode_rounding(v0_, std::sqrt(omega2_), t); }

private:
    long double omega2_, gamma_, v0_;
};

/// Particle 0 is the fixed end of the spring, at the origin; particle 1 oscillates.
Scene scene(const ParameterValues& values) {
    Scene scene;
    scene.particles = {{.group = "anchor", .mass = parameter(values, "m"), .fixed = true},
                       {.group = "mass",
                        .velocity = {parameter(values, "v0"), 0, 0},
                        .mass = parameter(values, "m"),
                        .role = Role::kicked}};
    scene.springs = {{.pairs = {{"anchor", "mass"}}, .k = parameter(values, "k")}};
    scene.fields = {{.drag = parameter(values, "c")}};
    return scene;
}

LineForces forces(const ParameterValues& values) {
    return {.count = 2, .first_fixed = true, .mass = values["m"], .k = values["k"], .rest_length = 0};
}

Plan plan(const ParameterValues& values) {
    return line_plan(forces(values), values["c"] / values["m"], {values["v0"], 0, 0});
}

Shape shape(const ParameterValues& values) {
    const double amplitude = std::abs(values["v0"]) / omega(values);
    Shape shape;
    shape.rest.assign(2, {});
    shape.roles = {Role::fixed, Role::kicked};
    shape.springs = {{0, 1, 0}};
    shape.spacing = amplitude > 0 ? amplitude : 1;
    shape.expected = {{amplitude, 0, 0}, {-amplitude, 0, 0}};
    return shape;
}

}  // namespace

const Model& oscillator_model() {
    static const Model model{
        .info = {.id = "oscillator",
                 .name = "Oscillator",
                 .what = "One particle, connected to the origin by a spring of rest length 0 and kicked along x.",
                 .parameters = parameters},
        .topic = "first steps",
        .particles = [](const ParameterValues&) { return 2.0; },
        .facts = [](const ParameterValues& values) { return line_facts(forces(values), values["c"] / values["m"]); },
        .scene = scene,
        .plan = plan,
        .shape = shape,
        .omega_max = [](const ParameterValues& values) { return std::optional<double>(omega(values)); },
        .exact = [](const ParameterValues& values) -> std::shared_ptr<const ExactSolution> {
            return std::make_shared<Solution>(values);
        },
    };
    return model;
}

}  // namespace steplab
