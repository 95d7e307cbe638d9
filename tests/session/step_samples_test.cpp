// What plots show of references and ensembles is the same at any rate of views.

#include "session/error_samples.hpp"
#include "session/live_errors.hpp"
#include "session/session.hpp"
#include "session/worker_test.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <random>
#include <vector>

namespace steplab::test {
namespace {

RunDescription mesh() { return run_of("mesh", "verlet", Precision::double_, 0.05, {{"dim", 3}}); }

constexpr std::uint64_t steps = 300, steps_of_the_other = 187;  // of 0.05 s and of 0.08 s in the same time

/// How many steps are taken between two views.
enum class Pace { all_at_once, one_by_one, by_chance };

std::uint64_t next_piece(Pace pace, std::mt19937& random) {
    if (pace == Pace::all_at_once) return steps;
    return pace == Pace::one_by_one ? 1 : 1 + random() % 70;
}

struct Series {
    std::vector<ErrorSeries> errors;
    SpreadSeries spread;
};

/// Of a run that is kicked at step 100 and stepped and seen in pieces.
class Played : public WorkerTest {
public:
    explicit Played(Pace pace) : WorkerTest(mesh()) {
        worker.send(event::Track{0});
        worker.send(event::ShowSamples{true});
        worker.send(event::AddRun{run_of("mesh", "rk4", Precision::double_, 0.08, {{"dim", 3}})});
        worker.send(event::ShowEnsemble{{.runs = 7, .spread = "k", .width = 0.01}});
        std::mt19937 random(2008);
        for (std::uint64_t step = 0; step < steps;) {
            std::uint64_t next = std::min(steps, step + next_piece(pace, random));
            if (step < 100) next = std::min<std::uint64_t>(next, 100);
            worker.send(event::Step{static_cast<std::int64_t>(next - step)});
            step = next;
            if (step == 100) worker.send(event::Do{Kick{4, {0.25, 0.5, 0}}});
            if (pace != Pace::all_at_once) see([&](const RunView& seen) { return seen.frame.step >= step; });
        }
    }
    void TestBody() override {}

    Series all() {
        see([&](const RunView&) {
            const auto& errors = session.error_series;
            const auto ends = [&](std::size_t run, std::uint64_t step) {
                return !errors[run].samples.empty() && errors[run].samples.back().step == step;
            };
            return view.frame.step == steps && errors.size() == 2 && ends(0, steps) && ends(1, steps_of_the_other) &&
                   !view.spread.samples.empty() && view.spread.samples.back().step == steps;
        });
        return {session.error_series, view.spread};
    }
};

void expect_same(const Series& a, const Series& b) {
    ASSERT_EQ(a.errors.size(), b.errors.size());
    for (std::size_t run = 0; run < a.errors.size(); ++run) {
        const auto &one = a.errors[run].samples, &other = b.errors[run].samples;
        ASSERT_EQ(one.size(), other.size());
        for (std::size_t i = 0; i < one.size(); ++i) {
            EXPECT_EQ(one[i].step, other[i].step);
            EXPECT_EQ(one[i].error, other[i].error) << run << " at step " << one[i].step;
            EXPECT_EQ(one[i].reference_error, other[i].reference_error);
        }
    }
    ASSERT_EQ(a.spread.samples.size(), b.spread.samples.size());
    for (std::size_t i = 0; i < a.spread.samples.size(); ++i) {
        EXPECT_EQ(a.spread.samples[i].step, b.spread.samples[i].step);
        EXPECT_EQ(a.spread.samples[i].largest, b.spread.samples[i].largest);
        ASSERT_TRUE(a.spread.samples[i].reach && b.spread.samples[i].reach);
        EXPECT_EQ(a.spread.samples[i].reach->low, b.spread.samples[i].reach->low);
        EXPECT_EQ(a.spread.samples[i].reach->high, b.spread.samples[i].reach->high);
    }
}

TEST(StepSamples, of_errors_and_ensembles_are_the_same_rows_however_often_they_are_seen) {
    const Series once = Played(Pace::all_at_once).all();
    ASSERT_EQ(once.errors[0].samples.size(), steps + 1);
    ASSERT_EQ(once.spread.samples.size(), steps + 1);
    EXPECT_GT(once.errors[0].samples.back().error, 10 * once.errors[1].samples.back().error) << "Verlet, RK4";
    EXPECT_GT(once.spread.samples.back().largest, 0);
    expect_same(Played(Pace::one_by_one).all(), once);
    expect_same(Played(Pace::by_chance).all(), once);
}

std::vector<ErrorSample> taken(ErrorSamples& samples) {
    while (samples.is_due()) samples.take();
    ErrorSeries series;
    samples.put_into(series);
    return series.samples;
}

TEST(ErrorSamples, are_those_of_the_command_compare) {
    ErrorSamples samples(mesh());
    const std::vector<SegmentBegin> start{{0, mesh()}};
    samples.follow(start, 60);
    Simulation run(mesh());
    ReferenceMotion motion(mesh());
    for (const ErrorSample& sample : taken(samples)) {
        run.advance(sample.step - run.step());
        const Compared right = compared(moment_of(run, {}), motion.at(run.time()), false);
        EXPECT_EQ(sample.error, right.error);
        EXPECT_EQ(sample.reference_error, right.reference_error);
    }
    EXPECT_EQ(run.step(), 60u);
}

// What was done at a step takes effect there; what is known before it stays.
TEST(ErrorSamples, follow_a_run_on_another_way) {
    Session session(mesh());
    session.advance(80);
    ErrorSamples samples(mesh());
    const auto follow = [&] { samples.follow(session.line().changes(), session.line().reached()); };
    follow();
    const std::vector<ErrorSample> before = taken(samples);
    session.handle(event::Seek{50});
    session.finish();
    session.handle(event::Do{Kick{4, {0.25, 0.5, 0}}});
    session.advance(40);
    follow();
    const std::vector<ErrorSample> now = taken(samples);
    ASSERT_EQ(now.size(), 91u);
    EXPECT_EQ(now[49].error, before[49].error);
    EXPECT_NE(now[70].error, before[70].error);
    ErrorSamples fresh(mesh());
    fresh.follow(session.line().changes(), session.line().reached());
    const std::vector<ErrorSample> right = taken(fresh);
    for (std::size_t i = 0; i < now.size(); ++i) EXPECT_EQ(now[i].error, right[i].error) << i;
}

// Of so many particles every second step has a sample: what was done between two of them is known at the next one.
TEST(ErrorSamples, follow_a_run_that_was_changed_between_two_of_them) {
    const RunDescription large = run_of("chain", "verlet", Precision::double_, 0.1, {{"n", 10000}});
    ASSERT_EQ(first_spacing(10000), 2u);
    TimeLine line(large);
    line.advance(20);
    ErrorSamples samples(large), fresh(large);
    samples.follow(line.changes(), line.reached());
    ASSERT_EQ(taken(samples).size(), 11u);
    line.turn_to(15);
    line.advance(15 - line.step());
    line.act(Kick{5, {0.25, 0.5, 0}});
    line.advance(5);
    samples.follow(line.changes(), line.reached());
    fresh.follow(line.changes(), line.reached());
    const std::vector<ErrorSample> now = taken(samples), right = taken(fresh);
    ASSERT_EQ(now.size(), right.size());
    for (std::size_t i = 0; i < now.size(); ++i) EXPECT_EQ(now[i].error, right[i].error) << i;
}

TEST(ErrorSamples, take_bounded_memory_and_end_where_the_run_does) {
    StepSamples<ErrorSample> rows(1);
    for (std::uint64_t step = 0; step < 1'000'000'000; step += rows.to_next(step)) rows.put({.step = step});
    EXPECT_LT(rows.all().size(), StepSamples<ErrorSample>::most);
    const RunDescription diverging = run_of("rope", "velocity-verlet", Precision::double_, 0.08);
    Session session(diverging);
    session.advance(1000);
    ASSERT_TRUE(session.line().is_over());
    ErrorSamples samples(diverging);
    samples.follow(session.line().changes(), session.line().reached());
    EXPECT_EQ(taken(samples).back().step, session.line().reached());
}

SpreadSeries spread_of(Session& session) {
    session.finish();
    SessionView view;
    session.observe(view);
    return view.leading.spread;
}

TEST(SpreadSamples, of_another_particle_are_taken_where_they_are_gone_through_again) {
    Session session(mesh());
    session.handle(event::ShowSamples{true});
    session.handle(event::ShowEnsemble{{.runs = 3, .spread = "k", .width = 0.01}});
    session.handle(event::Step{10});
    session.handle(event::Track{3});
    ASSERT_EQ(spread_of(session).samples.size(), 11u);
    EXPECT_FALSE(spread_of(session).samples[5].reach);
    session.handle(event::Seek{0});
    session.finish();
    session.handle(event::Step{10});
    EXPECT_TRUE(spread_of(session).samples[5].reach);
    session.handle(event::Track{5});
    EXPECT_FALSE(spread_of(session).samples[5].reach) << "that was the reach of particle 3";
}

TEST(SpreadSamples, behind_something_that_was_done_are_forgotten) {
    Session session(mesh());
    session.handle(event::ShowSamples{true});
    session.handle(event::ShowEnsemble{{.runs = 3, .spread = "k", .width = 0.01}});
    session.handle(event::Step{20});
    ASSERT_EQ(spread_of(session).samples.size(), 21u);
    session.handle(event::Seek{10});
    session.finish();
    session.handle(event::Do{Kick{4, {0.25, 0.5, 0}}});
    EXPECT_LE(spread_of(session).samples.size(), 11u) << "that of step 10 may be taken again";
}

// Verlet of mass m is stable up to dt = sqrt(m): the first of three masses is 0.5 kg.
TEST(SpreadSamples, leave_out_a_run_that_is_lost) {
    Session session(run_of("chain", "velocity-verlet", Precision::double_, 0.9));
    session.handle(event::Track{5});
    session.handle(event::ShowSamples{true});
    session.handle(event::ShowEnsemble{{.runs = 3, .spread = "m", .width = 0.5}});
    session.handle(event::Step{1000});
    const SpreadSeries spread = spread_of(session);
    ASSERT_EQ(spread.samples.size(), 1001u);
    ASSERT_TRUE(spread.samples.back().reach);
    const auto [low, high] = *spread.samples.back().reach;
    EXPECT_LE(low.x, high.x);
    EXPECT_LT(high.x - low.x, 10) << "neither of the others is anywhere else";
}

TEST(RunSamples, begin_with_what_was_done_at_step_0) {
    Session session(run_of("chain", "rk4", Precision::double_, 0.1, {{"v0", 0.25}}));
    session.handle(event::Track{4});
    session.handle(event::ShowSamples{true});
    const auto first = [&] {
        SessionView view;
        session.observe(view);
        return view.leading.series.samples.front();
    };
    const double still = first().particle()->displacement.x;
    session.handle(event::Do{Pull{4, session.run().frame().positions[4] + Vec3{0.0625, 0, 0}}});
    EXPECT_NE(first().particle()->displacement.x, still);
    EXPECT_EQ(first().particle()->displacement.x, session.run().state().displacement.at(4).x);
    EXPECT_TRUE(first().error) << "the exact solution goes on from there";
    session.advance(10);
    session.handle(event::Undo{});
    EXPECT_EQ(first().particle()->displacement.x, still);
}

}  // namespace
}  // namespace steplab::test
