#include "session/equal_cost.hpp"

#include "core/error.hpp"
#include "session/session.hpp"
#include "support/runs.hpp"

#include <gmock/gmock.h>

namespace steplab::test {
namespace {

/// Force evaluations per simulated second, until a time or where the run diverges.
double counted(const RunDescription& run, double time) {
    Simulation simulation(run);
    while (simulation.time() < time && !simulation.divergence()) simulation.advance(1);
    return static_cast<double>(simulation.evaluations()) / simulation.time();
}

// Ten in a hundred: what the window promises. Methods that choose their steps cannot be as costly as rk4 at dt = 0.02,
// whatever their tolerance, nor gauss-16 as cheap as rk4 at 0.1.
TEST(EqualCost, is_that_of_the_other_run_for_every_method) {
    for (const Method& each : methods()) {
        RunDescription rk4 = run_of("mesh", "rk4", Precision::double_, 0.02, {{"dim", 5}});
        if (chooses_its_steps(with_method(rk4, each.info.id))) rk4.dt = 0.1;
        const RunDescription run = at_equal_cost(with_method(rk4, each.info.id), rk4);
        SCOPED_TRACE(command_line(run));
        EXPECT_NEAR(counted(run, 20), counted(rk4, 20), 0.1 * counted(rk4, 20));
    }
}

TEST(EqualCost, of_explicit_methods_is_exact) {
    const RunDescription rk4 = run_of("chain", "rk4", Precision::double_, 0.1);
    EXPECT_EQ(evaluations_per_second(rk4), 40);
    EXPECT_EQ(at_equal_cost(with_method(rk4, "velocity-verlet"), rk4).dt, 0.025);
}

// At such a dt the equations of gauss-16 are not solved any more on the rope, whose springs are stiff.
TEST(EqualCost, that_a_method_cannot_have_is_refused_with_the_least_that_it_has) {
    const RunDescription verlet = run_of("rope", "velocity-verlet", Precision::double_, 0.01);
    try {
        at_equal_cost(run_of("rope", "gauss-16", Precision::double_, 0.01), verlet);
        FAIL() << "gauss-16 has 8 evaluations and more a step";
    } catch (const UsageError& error) {
        EXPECT_THAT(error.what(),
                    testing::HasSubstr("gauss-16 cannot cost 100 force evaluations per simulated second"));
    }
    Session session(verlet);
    session.handle(event::AddRun{run_of("rope", "gauss-16", Precision::double_, 0.01)});
    session.handle(event::EqualCost{true});
    SessionView view;
    session.observe(view);
    EXPECT_THAT(view.not_equal, testing::HasSubstr("gauss-16"));
    EXPECT_EQ(session.followers()[0].description().dt, 0.01);
    EXPECT_THROW(session.handle(event::AddRun{run_of("rope", "gauss-16", Precision::double_, 0.02)}), UsageError);
    for (const Event& ends : {Event(event::Undo{}), Event(event::EqualCost{true}), Event(event::RemoveRun{1})}) {
        session.handle(ends);
        session.observe(view);
        EXPECT_EQ(view.not_equal.empty(), !is_any<event::EqualCost>(ends)) << "what is no longer so is not said";
    }
}

TEST(EqualCost, of_a_tolerance_that_float_cannot_hold_is_refused) {
    EXPECT_THROW(at_equal_cost(run_of("chain", "dopri5", Precision::float_, 0.1),
                               run_of("chain", "rk4", Precision::double_, 1e-5)),
                 UsageError);
}

TEST(Session, keeps_all_runs_at_equal_cost_while_that_is_wanted) {
    Session session(run_of("chain", "rk4", Precision::double_, 0.1));
    session.handle(event::AddRun{run_of("chain", "velocity-verlet", Precision::double_, 0.1)});
    session.handle(event::EqualCost{true});
    EXPECT_EQ(session.followers()[0].description().dt, 0.025);
    session.handle(event::AddRun{run_of("chain", "euler", Precision::double_, 0.1)});
    EXPECT_EQ(session.followers()[1].description().dt, 0.025);
    session.handle(event::Change{run_of("chain", "rk4", Precision::double_, 0.2)});
    EXPECT_EQ(session.followers()[0].description().dt, 0.05);
    session.handle(event::EqualCost{false});
    session.handle(event::Change{run_of("chain", "rk4", Precision::double_, 0.1)});
    EXPECT_EQ(session.followers()[0].description().dt, 0.05);
}

TEST(Session, changes_also_where_a_run_beside_it_cannot_have_its_cost) {
    Session session(run_of("chain", "rk4", Precision::double_, 0.1));
    session.handle(event::AddRun{run_of("chain", "euler", Precision::float_, 0.1)});
    session.handle(event::EqualCost{true});
    session.handle(event::Change{run_of("chain", "rk4", Precision::double_, 1e300)});  // beyond any float
    EXPECT_EQ(session.run().description().dt, 1e300);
    EXPECT_EQ(session.followers()[0].description().dt, 0.025);
}

}  // namespace
}  // namespace steplab::test
