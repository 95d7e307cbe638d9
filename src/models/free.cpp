#include "models/model.hpp"
#include "models/parameters.hpp"
#include "models/scene/parameter.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace steplab {

namespace {

constexpr ParameterInfo parameters[] = {number_of_particles(1, 10), particle_mass(1)};

class Solution final : public ExactSolution {
public:
    explicit Solution(std::size_t count) : count_(count) {}

    /// From (i, 0, 0) at rest under (0, -0.1 i, 0); the reference positions are zero.
    Vec3 displacement(std::size_t particle, double t) const override {
        const double i = static_cast<double>(particle);
        return {i, -0.05 * i * t * t, 0};
    }
    Vec3 velocity(std::size_t particle, double t) const override {
        return {0, -0.1 * static_cast<double>(particle) * t, 0};
    }
    double rounding(double t) const override {
        return 2.3e-16 * static_cast<double>(count_) * (1 + 0.05 * t * t);  // a few products of half an ulp each
    }

private:
    std::size_t count_;
};

Scene scene(const ParameterValues& values) {
    Scene scene;
    scene.particles = {{.group = "free",
                        .mass = parameter(values, "m"),
                        .arrangement = LineArrangement{values.count("n"), {1, 0, 0}}}};
    for (std::size_t i = 1; i < values.count("n"); ++i) {
        scene.fields.push_back(
            {.particles = {fmt::format("free[{}]", i)}, .gravity = WrittenVector{0, -0.1 * static_cast<double>(i), 0}});
    }
    return scene;
}

Plan plan(const ParameterValues& values) {
    const std::size_t n = values.count("n");
    const auto at_rest = [](std::size_t i) { return Start::Particle{{static_cast<double>(i), 0, 0}, {}}; };
    return {.mass = values["m"],
            .forces = ConstantForces{.count = n, .mass = values["m"]},
            .reference = {.count = n},
            .start = {n, at_rest}};
}

Shape shape(const ParameterValues& values) {
    const std::size_t n = values.count("n");
    Shape shape;
    for (std::size_t i = 0; i < n; ++i) shape.rest.push_back({static_cast<double>(i), 0, 0});
    shape.roles.assign(n, Role::moving);
    shape.spacing = 1;
    // The fall has no end; this covers its first seconds.
    shape.expected = {{static_cast<double>(n - 1), -0.5 * static_cast<double>(n), 0}};
    return shape;
}

}  // namespace

const Model& free_model() {
    static const Model model{
        .info = {.id = "free",
                 .name = "Free particles",
                 .what = "Particles in free fall without interaction; particle i has the constant acceleration 0.1 i.",
                 .parameters = parameters},
        .topic = "first steps",
        .particles = [](const ParameterValues& values) { return values["n"]; },
        .facts = [](const ParameterValues& values) { return SceneFacts{.mass = values["m"]}; },
        .scene = scene,
        .plan = plan,
        .shape = shape,
        .omega_max = [](const ParameterValues&) { return std::optional<double>(0.0); },
        .exact = [](const ParameterValues& values) -> std::shared_ptr<const ExactSolution> {
            return std::make_shared<Solution>(values.count("n"));
        },
    };
    return model;
}

}  // namespace steplab
