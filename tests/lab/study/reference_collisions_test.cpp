#include "lab/study/advice.hpp"
#include "lab/study/reference.hpp"
#include "methods/engines/extrapolation.hpp"
#include "sim/steppers/stepper_of.hpp"
#include "support/runs.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <span>
#include <string>
#include <tuple>
#include <variant>
#include <vector>

// References share the code that finds and crosses collisions with the methods that are compared with them. Here they
// are compared with what does not depend on it: closed forms on both sides of a collision, and energy.

namespace steplab::test {
namespace {

using Real = long double;

RunDescription morse(Settings settings) { return run_of("morse", "rkn-12-10", Precision::double_, 0.1, settings); }

const RunDescription cube = morse({{"spacing", 0.5}, {"v0", 1.5}});

/// Two particles of equal mass, head on, until as long after their collision as they started before it. The force is an
/// odd function of the distance: after the collision the distance is that of the same time before, reversed.
class PassedHeadOn {
public:
    explicit PassedHeadOn(const RunDescription& scene)
        : v0_(scene.scene["v0"]), before_(model("morse").exact(scene.scene)) {}

    double collision() const { return before_->valid_until(); }

    /// Positions of the first and the second particle, at a time not before the collision.
    std::vector<double> positions(double time) const {
        const double as_long_before = 2 * collision() - time;
        const double distance = before_->displacement(0, as_long_before).x - before_->displacement(1, as_long_before).x;
        const double centre = -5 + v0_ / 2 * time;
        return {centre - distance / 2, centre + distance / 2};
    }

private:
    double v0_;
    std::shared_ptr<const ExactSolution> before_;
};

/// Largest distance of the two particles from these positions.
double distance(const std::vector<double>& positions, const Field<double>& displacement) {
    return std::max(std::abs(displacement.x()[0] - positions[0]), std::abs(displacement.x()[1] - positions[1]));
}

/// Rounding of the closed form: distances of 20 and times of 20 in double.
constexpr double rounding = 1e-13;

TEST(ReferenceBehindACollision, is_the_closed_form_of_two_particles) {
    for (const auto& [v0, k, depth] : {std::tuple{1.0, 0.5, 1.0}, {0.2, 0.5, 1.0}, {6.0, 2.0, 3.0}}) {
        const RunDescription scene = morse({{"edge", 1}, {"v0", v0}, {"k", k}, {"D", depth}});
        const PassedHeadOn exact(scene);
        const std::vector<double> times{exact.collision() + 0.01, 1.3 * exact.collision(), 1.9 * exact.collision()};
        const Reference run = reference_run(scene, times);
        EXPECT_NE(run.how.find("1 collision crossed"), std::string::npos) << run.how;
        for (const ReferenceMoment& moment : run.moments) {
            EXPECT_LT(distance(exact.positions(moment.time), moment.state.displacement), rounding) << v0;
            EXPECT_LT(moment.error, 1e-14) << v0;
        }
    }
}

/// Morse pairs whose positions are given to the locator with an error.
struct Misplaced : Pairs<Real> {
    Misplaced(const PairForces& forces, Real by) : Pairs<Real>(forces), by_(by) {}

    Vector<Real> separation(const Field<Real>& u, std::size_t i, std::size_t j) const {
        Vector<Real> d = Pairs<Real>::separation(u, i, j);
        d.x += by_;
        return d;
    }

private:
    Real by_;
};

/// A run with the adaptive steps of the reference and such a locator.
Field<double> misplaced_run(const RunDescription& description, double time, Real by) {
    const Plan scene = model("morse").plan(description.scene);
    System<Real, Misplaced> system(Misplaced(std::get<PairForces>(scene.forces), by), 0, time);
    ParameterValues values(std::span(&tolerance_parameter, 1));
    values.set(tolerance_parameter.name, 1e-15);
    AdaptiveSteps<Real, ExtrapolationRule<Real>> integrator(values);
    integrator.start(system, scene.start.state<Real>());
    integrator.step(system);
    State<Real> state;
    integrator.synchronised(system, state);
    return converted<double>(state.displacement);
}

// The partner: the same steps, and a locator with a relative error of 1e-6. (Without any locator the result need not be
// wrong: error control may take the steps through a single jump.)
TEST(ReferenceBehindACollision, is_wrong_with_a_wrong_locator) {
    const RunDescription scene = morse({{"edge", 1}});
    const PassedHeadOn exact(scene);
    const double time = 1.9 * exact.collision();
    const auto error = [&](Real by) { return distance(exact.positions(time), misplaced_run(scene, time, by)); };
    EXPECT_LT(error(0), rounding);
    EXPECT_GT(error(1e-6L), 100 * rounding);
    EXPECT_GT(error(-1e-6L), 100 * rounding);
}

double energy(const State<double>& state) {
    const Pairs<double> forces(std::get<PairForces>(model("morse").plan(cube.scene).forces));
    double twice_kinetic = 0;
    for (const double v : state.velocity.flat()) twice_kinetic += v * v;
    return twice_kinetic / 2 + forces.potential(state.displacement).value;
}

// Six collisions, and errors amplified about a thousand times: an error of 1e-10 is still well above that of the
// reference. Energy is independent of the collisions: 378 pairs and 28 particles, -331 in total, are accurate to a few
// ulps of 6e-14.
TEST(ReferenceOfTheCollidingCube, supports_answers_at_1e_10) {
    StudyPlan plan{
        .scene = cube, .time = 5, .methods = {"rkn-12-10"}, .method_settings = {}, .precisions = {Precision::double_}};
    plan.most_seconds_a_run = 10;  // the search is not ended by time
    const Reference right = reference_for(plan, 1e-13);
    const ReferenceMoment& end = right.moments.back();
    EXPECT_NE(right.how.find("6 collisions crossed"), std::string::npos) << right.how;
    EXPECT_LT(end.error, 3e-11);
    const double start = energy(model("morse").plan(cube.scene).start.state());
    EXPECT_NEAR(energy(end.state), start, 1e-12);

    const Advice advice = advise(plan, 1e-10, right, [](double) {});
    Simulation simulation(advice.best.run);
    simulation.advance(advice.best.steps);
    EXPECT_LE(error_against(end, simulation.state().displacement), 1e-10);
    EXPECT_EQ(simulation.collisions().count(), 6u);

    // the partner: steps without a locator
    Simulation blind(with_method(cube, "rk4"));
    blind.advance(50);
    EXPECT_GT(error_against(end, blind.state().displacement), 1e-4);
    EXPECT_GT(std::abs(energy(blind.state()) - start), 1e-4);
}

}  // namespace
}  // namespace steplab::test
