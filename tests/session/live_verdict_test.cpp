#include "session/live_verdict.hpp"

#include "session/time_line.hpp"
#include "session/worker_test.hpp"
#include "support/allocations.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>

namespace steplab::test {
namespace {

/// A cluster that a bullet runs into: its fastest oscillation changes all the time.
class LiveVerdictTest : public WorkerTest {
protected:
    LiveVerdictTest() : WorkerTest(run_of("morse", "velocity-verlet", Precision::double_, 0.02)) {}

    bool see_present(std::uint64_t step) {
        return see(
            [&](const RunView& v) { return v.frame.step == step && session.present && session.present->step == step; });
    }
    static PresentLimit present(const Simulation& run) {
        return PresentLimits().at(run.description(), run.state(), run.step(), run.time());
    }
};

TEST_F(LiveVerdictTest, is_of_the_moment_where_the_run_stands) {
    Simulation alone(view.description);
    for (const std::uint64_t step : {std::uint64_t{300}, std::uint64_t{500}}) {
        worker.send(event::Seek{step});
        ASSERT_TRUE(see_present(step));
        alone.advance(step - alone.step());
        const PresentLimit expected = present(alone);
        EXPECT_EQ(session.present->oscillation.omega, expected.oscillation.omega) << step;
        EXPECT_EQ(session.present->limit, expected.limit) << step;
        EXPECT_EQ(view.frame.oscillation, expected.oscillation.shape) << step;
    }
}

// Something is done to a particle where the run stands: the scene is another at the same step.
TEST_F(LiveVerdictTest, follows_an_act_at_the_same_step) {
    worker.send(event::Seek{300});
    ASSERT_TRUE(see_present(300));
    const double before = session.present->oscillation.omega;
    worker.send(event::Do{Pull{0, view.frame.positions[1] + Vec3{0.3, 0, 0}}});
    ASSERT_TRUE(see([&](const RunView&) { return session.present && session.present->oscillation.omega != before; }));
    EXPECT_EQ(session.present->step, 300u);
}

TEST_F(LiveVerdictTest, of_another_method_is_another_at_the_same_step) {
    worker.send(event::Seek{300});
    ASSERT_TRUE(see_present(300));
    const double before = session.present->limit.value();
    RunDescription other = with_method(view.description, "rk4");
    worker.send(event::Change{other});
    ASSERT_TRUE(see([&](const RunView& v) {
        return v.description == other && session.present && session.present->limit != before;
    }));
    EXPECT_NEAR(*session.present->limit, before * std::sqrt(2), 1e-9) << "2 sqrt(2) instead of 2 over omega";
}

TEST_F(LiveVerdictTest, of_a_scene_too_large_for_it_is_none) {
    RunDescription large = run_of("mesh", "rk4", Precision::double_, 0.1, {{"dim", 150}});
    worker.send(event::Change{large});
    ASSERT_TRUE(see([&](const RunView& v) { return v.description == large; }));
    EXPECT_FALSE(session.present);
    EXPECT_TRUE(view.frame.oscillation.empty());
    EXPECT_TRUE(view.limit) << "that at rest is known";
}

LiveVerdict::Moment moment_at(const Simulation& run) {
    return {run.description(), run.step(), run.segment(), run.time(), run.state()};
}

// The answer does not come while there is no memory for it: until then nothing is known of the other run.
TEST(LiveVerdict, of_another_run_is_not_that_of_the_one_before) {
    const Simulation one(run_of("chain", "rk4", Precision::double_, 0.1)),
        other(run_of("chain", "velocity-verlet", Precision::double_, 0.1));
    LiveVerdict verdict(News::wake);
    verdict.ask(moment_at(one));
    ASSERT_TRUE(verdict.limit(std::chrono::seconds(60)));
    const NoMemoryElsewhere none;
    verdict.ask(moment_at(other));
    EXPECT_FALSE(verdict.limit(std::chrono::seconds(0)));
}

TEST(LiveVerdict, of_a_blow_up_is_forgotten_with_it) {
    TimeLine line(run_of("chain", "rk4", Precision::double_, 2));
    while (!line.is_over()) line.advance(100);
    LiveVerdict verdict(News::wake);
    verdict.ask_why(line, *line.run().divergence());
    while (!verdict.blow_up()) ASSERT_TRUE(News::wait());
    verdict.forget_why();
    EXPECT_FALSE(verdict.blow_up());
}

}  // namespace
}  // namespace steplab::test
