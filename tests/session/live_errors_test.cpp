#include "session/live_errors.hpp"

#include "session/comparison.hpp"
#include "session/session.hpp"
#include "session/worker_test.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <vector>

namespace steplab::test {
namespace {

RunDescription mesh(std::string_view method, double dt, Precision precision = Precision::double_) {
    return run_of("mesh", method, precision, dt, {{"dim", 5}});
}

class LiveErrorsTest : public WorkerTest {
protected:
    LiveErrorsTest() : WorkerTest(mesh("rk4", 0.1)) {}

    bool errors_at(std::uint64_t step) {
        return see([&](const RunView& seen) {
            return seen.frame.step == step && session.errors && session.errors->time == seen.frame.time;
        });
    }
};

void expect_equal(const Compared& live, const Compared& right) {
    EXPECT_EQ(live.step, right.step);
    EXPECT_EQ(live.time, right.time);
    EXPECT_EQ(live.error, right.error);
    EXPECT_EQ(live.rms_error, right.rms_error);
    EXPECT_EQ(live.energy_error, right.energy_error);
    EXPECT_EQ(live.momentum_error, right.momentum_error);
    EXPECT_EQ(live.reference_error, right.reference_error);
    EXPECT_EQ(live.phase_error, right.phase_error);
    EXPECT_EQ(live.evaluations, right.evaluations);
}

// To the last digit, whatever the window asked for before.
TEST_F(LiveErrorsTest, are_those_of_the_command_compare) {
    const std::vector<RunDescription> runs{mesh("rk4", 0.1), mesh("verlet", 0.03),
                                           mesh("midpoint", 0.2, Precision::float_)};
    worker.send(event::AddRun{runs[1]});
    worker.send(event::AddRun{runs[2]});
    std::uint64_t step = 0;
    for (const std::uint64_t target : {3U, 4U, 20U, 50U}) {
        worker.send(event::Step{static_cast<std::int64_t>(target - step)});
        step = target;
        ASSERT_TRUE(errors_at(step));
        ASSERT_EQ(session.errors->runs.size(), 3u);
        RunComparison comparison(runs, session.errors->time, 1);
        const auto right = comparison.at(1);
        for (std::size_t i = 0; i < 3; ++i) {
            ASSERT_TRUE(session.errors->runs[i] && right[i]);
            expect_equal(*session.errors->runs[i], *right[i]);
        }
    }
    EXPECT_GT(session.errors->runs[1]->error, session.errors->runs[0]->error);
    EXPECT_FALSE(session.errors->exact);
}

TEST_F(LiveErrorsTest, are_there_for_one_run_unless_that_is_not_wanted) {
    worker.send(event::Step{2});
    ASSERT_TRUE(errors_at(2)) << "few particles, and no exact solution";
    worker.send(event::ShowErrors{false});
    ASSERT_TRUE(see([&](const RunView&) { return !session.errors; }));
    worker.send(event::Change{run_of("chain", "rk4", Precision::double_, 0.1)});
    worker.send(event::ShowErrors{true});
    EXPECT_TRUE(errors_at(0));
    EXPECT_TRUE(session.errors->exact);
}

TEST(Session, compares_a_run_alone_where_that_costs_little_and_says_more) {
    EXPECT_TRUE(Session(mesh("rk4", 0.1)).wants_errors());
    EXPECT_FALSE(Session(run_of("chain", "rk4", Precision::double_, 0.1)).wants_errors()) << "it has an exact solution";
    Session large(run_of("mesh", "rk4", Precision::double_, 0.1, {{"dim", 20}}));
    EXPECT_FALSE(large.wants_errors());
    large.handle(event::AddRun{run_of("mesh", "verlet", Precision::double_, 0.1, {{"dim", 20}})});
    EXPECT_TRUE(large.wants_errors());
}

// After a pull the motion is that of the pulled scene, for runs and reference alike.
TEST_F(LiveErrorsTest, go_on_after_a_pull_and_a_change_of_the_scene) {
    worker.send(event::ShowErrors{true});
    worker.send(event::Step{10});
    worker.send(event::Do{Pull{6, {2, 0.5, -2}}});
    RunDescription stiffer = mesh("rk4", 0.02);
    stiffer.scene.set("k", 1.5);
    worker.send(event::Step{5});
    worker.send(event::Change{stiffer});
    worker.send(event::Step{100});
    ASSERT_TRUE(errors_at(115));
    EXPECT_LT(session.errors->runs[0]->error, 1e-3) << "of the first fifteen steps of 0.1 s";
    EXPECT_GT(session.errors->runs[0]->error, 1e-12);
    EXPECT_LT(session.errors->runs[0]->reference_error, 1e-13);
    EXPECT_FALSE(session.errors->runs[0]->momentum_error);
}

// The motion that the errors are told of is that of the leading run.
TEST(LiveErrors, say_how_the_motion_of_the_first_run_is_known) {
    const TimeLine exact(run_of("chain", "rk4", Precision::double_, 0.1)), other(mesh("rk4", 0.1));
    std::vector<LiveErrors::Shown> shown;
    for (const TimeLine* line : {&exact, &other})
        shown.push_back({moment_of(line->run(), line->start_momentum()), {line->past().begin(), line->past().end()}});
    LiveErrors errors([] {});
    errors.ask(0, shown);
    const auto found = errors.newest(std::chrono::seconds(60));
    ASSERT_TRUE(found);
    EXPECT_EQ(found->runs.size(), 2u);
    EXPECT_TRUE(found->exact);
}

// It stands before the time of the others.
TEST(LiveErrors, of_a_run_that_ended_are_none) {
    const TimeLine line(mesh("rk4", 0.1));
    const LiveErrors::Shown shown{moment_of(line.run(), line.start_momentum()),
                                  {line.past().begin(), line.past().end()}};
    LiveErrors errors([] {});
    for (const bool over : {false, true}) {
        std::vector<LiveErrors::Shown> runs{shown};
        runs.front().over = over;
        errors.ask(0, runs);
        const auto found = errors.newest(std::chrono::seconds(60));
        ASSERT_TRUE(found && found->runs.size() == 1);
        EXPECT_EQ(found->runs.front().has_value(), !over);
    }
}

}  // namespace
}  // namespace steplab::test
