#include "lab/limits/present_limit.hpp"

#include "sim/catalogue.hpp"
#include "sim/run/linear_limit.hpp"
#include "sim/run/linearised.hpp"
#include "sim/run/starting.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace steplab {

namespace {

/// Of an eigenvalue omega^2: half of it of omega, below what is shown.
constexpr double accuracy = 1e-5;

/// The scene of a run: its method and dt make no difference.
bool same_scene(const RunDescription& one, RunDescription other) {
    other.method = one.method;
    other.method_parameters = one.method_parameters;
    other.dt = one.dt;
    return one == other;
}

FastestOscillation oscillation_of(const LinearisedScene& scene, const Plan& plan, const Field<double>& velocity) {
    const auto product = [&](const Eigen::VectorXd& u) { return scene.stiffness(u); };
    const Eigenpair found = largest_eigenpair(product, scene.weighted(velocity), accuracy);
    FastestOscillation fastest{.omega = found.value > 0 ? std::sqrt(found.value) : 0, .shape = {}, .weights = {}};
    if (fastest.omega == 0) return fastest;
    const Field<double> shape = scene.displacements(found.vector), weighted = scene.field(found.vector);
    double longest = 0;
    for (std::size_t i = 0; i < shape.count(); ++i) longest = std::max(longest, length(shape.at(i)));
    fastest.shape.reserve(shape.count());
    fastest.weights.reserve(shape.count());
    for (std::size_t i = 0; i < plan.reference.count; ++i) {
        fastest.shape.push_back((1 / longest) * shape.at(i));
        fastest.weights.push_back(dot(weighted.at(i), weighted.at(i)));
    }
    return fastest;
}

}  // namespace

struct PresentLimits::Body {
    RunDescription description;
    Plan plan;
    Shape shape;
};

PresentLimits::PresentLimits() = default;
PresentLimits::~PresentLimits() = default;
PresentLimits::PresentLimits(PresentLimits&&) noexcept = default;
PresentLimits& PresentLimits::operator=(PresentLimits&&) noexcept = default;

const Plan& PresentLimits::plan(const RunDescription& description) {
    if (!body_ || !same_scene(body_->description, description)) {
        const RunDescription held = as_held(description);
        body_ = std::make_unique<Body>(Body{description, plan_of(held), model_of(held).shape(held.scene)});
    }
    return body_->plan;
}

FastestOscillation PresentLimits::oscillation(const RunDescription& description, const State<double>& state) {
    const Plan& scene = plan(description);
    return oscillation_of(LinearisedScene(scene, body_->shape, state.displacement), scene, state.velocity);
}

PresentLimit PresentLimits::at(const RunDescription& description, const State<double>& state, std::uint64_t step,
                               double time) {
    PresentLimit found{.step = step, .time = time, .oscillation = oscillation(description, state)};
    const double omega = found.oscillation.omega;
    if (!chooses_its_steps(description) && omega <= largest_frequency) found.limit = linear_limit(description, omega);
    found.resolution = steplab::resolution(description, omega);
    return found;
}

}  // namespace steplab
