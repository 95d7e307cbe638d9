#include "session/time_line.hpp"

#include "support/runs.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>
#include <string>
#include <vector>

namespace steplab::test {
namespace {

using Hashes = std::map<std::uint64_t, std::string>;

/// Takes steps one by one and notes the hash of each.
void record(TimeLine& line, Hashes& hashes, int steps) {
    hashes[line.step()] = line.run().hash();
    for (int i = 0; i < steps; ++i) {
        line.advance(1);
        line.keep_moment();
        hashes[line.step()] = line.run().hash();
    }
}

void go_to(TimeLine& line, std::uint64_t step) {
    line.turn_to(step);
    line.advance(step - line.step());
}

void expect_same(TimeLine& line, const Hashes& hashes, unsigned seed) {
    std::mt19937 random(seed);
    std::vector<std::uint64_t> steps;
    for (const auto& [step, hash] : hashes) steps.push_back(step);
    std::shuffle(steps.begin(), steps.end(), random);
    for (const std::uint64_t step : steps) {
        go_to(line, step);
        ASSERT_EQ(line.step(), step);
        ASSERT_EQ(line.run().hash(), hashes.at(step)) << "step " << step;
    }
}

RunDescription with(RunDescription run, std::string_view name, double value) {
    if (name == "dt") {
        run.dt = value;
    } else {
        run.scene.set(name, value);
    }
    return run;
}

class TimeLineOf : public testing::TestWithParam<MethodCase> {};

// Forward and back, through changes of every kind, in any order.
TEST_P(TimeLineOf, every_step_has_the_same_bits_whenever_it_is_gone_to) {
    RunDescription run = run_of("chain", GetParam().id(), GetParam().precision, 0.1);
    TimeLine line(run);
    Hashes hashes;
    record(line, hashes, 40);
    line.change(with(run, "dt", 0.05));
    record(line, hashes, 20);
    line.act(Pull{5, {10, 1, 0}});
    line.act(Kick{6, {0, 0.1, 0.1}});
    record(line, hashes, 20);
    line.act(TurnRound{});
    line.change(with(line.run().description(), "k", 1.5));
    record(line, hashes, 20);
    EXPECT_EQ(line.past().size(), 6u);
    EXPECT_EQ(line.reached(), 100u);
    expect_same(line, hashes, 1);
    EXPECT_EQ(line.reached(), 100u) << "what lies ahead is kept";
    EXPECT_EQ(line.changes().size(), 6u);
}

TEST_P(TimeLineOf, going_back_step_by_step_has_the_bits_of_going_on) {
    const RunDescription run = run_of("chain", GetParam().id(), GetParam().precision, 0.1);
    TimeLine line(run);
    Hashes hashes;
    record(line, hashes, 150);
    line.act(Kick{6, {0, 0.1, 0.1}});
    record(line, hashes, 90);
    for (std::uint64_t step = line.step(); step > 0;) {
        const std::uint64_t back = 1 + step % 3;
        line.step_back(back);
        step -= std::min(step, back);
        ASSERT_EQ(line.step(), step);
        ASSERT_EQ(line.run().hash(), hashes.at(step)) << "step " << step;
    }
    EXPECT_EQ(line.reached(), 240u);
}

INSTANTIATE_TEST_SUITE_P(Methods, TimeLineOf, testing::ValuesIn(all_methods()), case_name);

TEST(TimeLine, keeps_to_its_memory_and_still_reaches_every_step) {
    const RunDescription run = run_of("mesh", "rk4", Precision::double_, 0.1, {{"dim", 30}});
    const std::size_t one = Simulation(run).save().bytes();
    TimeLine line(run, 4 * one);
    Hashes hashes;
    record(line, hashes, 200);
    EXPECT_LE(line.bytes(), 5 * one);
    go_to(line, 3);
    EXPECT_EQ(line.run().hash(), hashes.at(3)) << "from the start again, of which no moment is left";
    go_to(line, 199);
    EXPECT_EQ(line.run().hash(), hashes.at(199));
}

TEST(TimeLine, steps_back_sixty_steps_or_a_million) {
    TimeLine line(run_of("chain", "velocity-verlet", Precision::double_, 0.1));
    line.advance(1'000'000 - 60);
    const std::string sixty = line.run().hash();
    for (int i = 0; i < 60; ++i) line.advance(1), line.keep_moment();
    go_to(line, 1'000'000 - 60);
    EXPECT_EQ(line.run().hash(), sixty);
    go_to(line, 0);
    EXPECT_EQ(line.run().hash(), Simulation(line.run().description()).hash());
    go_to(line, 1'000'000 - 60);
    EXPECT_EQ(line.run().hash(), sixty);
}

TEST(TimeLine, branches_where_something_else_is_done) {
    const RunDescription run = run_of("chain", "verlet", Precision::double_, 0.1);
    TimeLine line(run);
    Hashes first, second;
    record(line, first, 30);
    line.change(with(run, "dt", 0.2));
    record(line, first, 30);
    go_to(line, 20);
    auto left = line.act(Pull{5, {10, 1, 0}});
    ASSERT_TRUE(left);
    EXPECT_EQ(left->fork, 20u);
    EXPECT_EQ(left->reached, 60u);
    EXPECT_EQ(line.reached(), 20u);
    for (std::uint64_t step = 0; step < 20; ++step) second[step] = first[step];
    record(line, second, 30);
    expect_same(line, second, 2);
    auto other = line.take(std::move(*left));
    EXPECT_EQ(line.step(), 20u);
    expect_same(line, first, 3);
    ASSERT_TRUE(other);
    line.take(std::move(*other));
    EXPECT_EQ(line.past().size(), 2u) << "the pull took effect again";
    expect_same(line, second, 4);
}

// Where memory is short, the moment behind the change may be gone, and those of the way that was left must not serve.
TEST(TimeLine, does_not_mistake_moments_of_another_way_for_its_own) {
    const RunDescription run = run_of("mesh", "rk4", Precision::double_, 0.1, {{"dim", 20}});
    const std::size_t one = Simulation(run).save().bytes();
    TimeLine line(run, 6 * one);
    Hashes plain, kicked;
    record(line, plain, 120);
    go_to(line, 10);
    line.act(Kick{100, {0, 0.5, 0}});
    record(line, kicked, 200);
    expect_same(line, kicked, 6);
}

TEST(TimeLine, takes_back_what_was_done) {
    const RunDescription run = run_of("chain", "pefrl", Precision::float_, 0.1);
    TimeLine line(run);
    Hashes plain, pulled;
    record(line, plain, 20);
    line.act(Pull{5, {10, 1, 0}});
    record(line, pulled, 20);
    auto undone = line.undo();
    EXPECT_EQ(line.step(), 20u);
    EXPECT_EQ(line.run().hash(), plain.at(20));
    EXPECT_EQ(line.past().size(), 1u);
    ASSERT_TRUE(undone);
    line.take(std::move(*undone));
    EXPECT_EQ(line.run().hash(), pulled.at(20));
    expect_same(line, pulled, 5);
    line.undo();
    EXPECT_FALSE(line.undo()) << "only the start is left";
}

TEST(TimeLine, a_dragged_slider_and_a_dragged_particle_leave_one_change) {
    const RunDescription run = run_of("chain", "rk4", Precision::double_, 0.1);
    TimeLine line(run);
    line.advance(10);
    for (const double dt : {0.11, 0.12, 0.2}) line.change(with(run, "dt", dt));
    EXPECT_EQ(line.changes().size(), 2u);
    for (const double y : {0.1, 0.2, 0.3}) line.act(Pull{5, {10, y, 0}});
    EXPECT_EQ(line.changes().size(), 3u);
    line.act(Pull{6, {12, 1, 0}});
    line.act(Kick{6, {1, 0, 0}});
    line.act(Kick{6, {1, 0, 0}});
    EXPECT_EQ(line.changes().size(), 6u) << "two kicks are two";
    TimeLine once(run);
    once.advance(10);
    once.change(with(run, "dt", 0.2));
    once.act(Pull{5, {10, 0.3, 0}});
    once.act(Pull{6, {12, 1, 0}});
    once.act(Kick{6, {1, 0, 0}});
    once.act(Kick{6, {1, 0, 0}});
    EXPECT_EQ(line.run().hash(), once.run().hash());
    EXPECT_EQ(line.run().evaluations(), once.run().evaluations());
}

TEST(TimeLine, knows_the_times_of_its_steps) {
    TimeLine line(run_of("chain", "rk4", Precision::double_, 0.25));
    line.advance(8);
    line.change(with(line.run().description(), "dt", 0.5));
    line.advance(8);
    EXPECT_EQ(line.time_of(4), 1);
    EXPECT_EQ(line.time_of(8), 2);
    EXPECT_EQ(line.time_of(12), 4);
    EXPECT_EQ(line.step_at(1.9), 7u);
    EXPECT_EQ(line.step_at(2), 8u);
    EXPECT_EQ(line.step_at(2.4), 8u);
    EXPECT_EQ(line.step_at(4.6), 13u);
    EXPECT_EQ(line.reached_time(), 6);
}

// The partner: another course of events is another run.
TEST(TimeLine, another_change_gives_other_bits) {
    TimeLine one(run_of("chain", "rk4", Precision::double_, 0.1)),
        other(run_of("chain", "rk4", Precision::double_, 0.1));
    one.advance(10);
    other.advance(11);
    for (TimeLine* line : {&one, &other}) line->act(Kick{5, {0.1, 0, 0}});
    go_to(one, 40);
    go_to(other, 40);
    EXPECT_NE(one.run().hash(), other.run().hash());
}

}  // namespace
}  // namespace steplab::test
