#include "session/history.hpp"

#include "support/runs.hpp"

#include <gtest/gtest.h>

#include <map>

namespace steplab::test {
namespace {

/// Runs `steps` steps one by one, offering every moment, and remembers the hash of each.
std::map<std::uint64_t, std::string> record(Simulation& simulation, History& history, int steps) {
    std::map<std::uint64_t, std::string> hashes;
    history.offer(simulation);
    hashes[simulation.step()] = simulation.hash();
    for (int i = 0; i < steps; ++i) {
        simulation.advance(1);
        history.offer(simulation);
        hashes[simulation.step()] = simulation.hash();
    }
    return hashes;
}

TEST(History, steps_back_to_the_same_bits) {
    for (const MethodCase& c : all_methods()) {
        Simulation simulation(run_of("mesh", c.id(), c.precision, 0.1));
        History history;
        const auto hashes = record(simulation, history, 60);
        while (simulation.step() > 0) {
            ASSERT_TRUE(history.reaches_before(simulation.step()));
            history.go_back(simulation, simulation.step() - 1);
            ASSERT_EQ(simulation.hash(), hashes.at(simulation.step())) << c;
        }
        EXPECT_FALSE(history.reaches_before(0));
    }
}

TEST(History, leads_back_through_changes) {
    Simulation simulation(run_of("chain", "verlet", Precision::double_, 0.1));
    History history;
    const auto before = record(simulation, history, 20);
    RunDescription other = with_method(simulation.description(), "rk4");
    other.dt = 0.05;
    simulation.change(other);
    const auto after = record(simulation, history, 20);
    while (simulation.step() > 21) {
        history.go_back(simulation, simulation.step() - 1);
        ASSERT_EQ(simulation.hash(), after.at(simulation.step()));
    }
    history.go_back(simulation, 12);
    EXPECT_EQ(simulation.hash(), before.at(12));
    EXPECT_EQ(simulation.description().method, "verlet");
    simulation.advance(8);
    EXPECT_EQ(simulation.hash(), before.at(20));
}

TEST(History, reaches_the_start_however_long_the_run) {
    Simulation simulation(run_of("chain", "euler", Precision::double_, 0.1));
    History history;
    history.offer(simulation);
    for (int i = 0; i < 20000; ++i) {
        simulation.advance(16);
        history.offer(simulation);
    }
    EXPECT_TRUE(history.reaches_before(1));
    history.go_back(simulation, 5);
    EXPECT_EQ(simulation.step(), 5u);
}

TEST(History, keeps_to_its_memory_and_then_forgets_the_oldest) {
    Simulation simulation(run_of("mesh", "rk4", Precision::double_, 0.1, {{"dim", 50}}));
    const std::size_t one = simulation.save().bytes();
    History history(4 * one);
    const auto hashes = record(simulation, history, 300);
    EXPECT_LE(history.bytes(), 5 * one);
    const std::uint64_t back = simulation.step() - 1;
    history.go_back(simulation, back);
    EXPECT_EQ(simulation.hash(), hashes.at(back));
}

TEST(History, without_moments_changes_nothing) {
    Simulation simulation(run_of("chain", "rk4", Precision::double_, 0.1));
    History history;
    simulation.advance(3);
    history.go_back(simulation, 2);
    EXPECT_EQ(simulation.step(), 3u);
    history.offer(simulation);
    history.clear();
    EXPECT_FALSE(history.reaches_before(3));
}

}  // namespace
}  // namespace steplab::test
