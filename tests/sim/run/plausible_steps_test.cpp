#include "sim/run/plausible_steps.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace steplab {
namespace {

/// The steps that a run is stopped at, up to its end.
std::vector<std::uint64_t> stops(Simulation& simulation, std::uint64_t end, std::uint64_t every) {
    PlausibleSteps steps(end, [](std::uint64_t) {});
    std::vector<std::uint64_t> at;
    for (std::uint64_t stop = every; stop <= end && !simulation.divergence(); stop += every) {
        steps.advance(simulation, stop);
        at.push_back(simulation.step());
    }
    return at;
}

TEST(PlausibleSteps, take_no_step_twice) {
    const RunDescription run = describe("chain");
    Simulation straight(run), stopped(run);
    straight.advance(1000);
    EXPECT_EQ(stops(stopped, 1000, 1).size(), 1000u);
    EXPECT_EQ(stopped.hash(), straight.hash());
    EXPECT_EQ(stopped.evaluations(), straight.evaluations());
}

TEST(PlausibleSteps, end_with_the_last_good_step_wherever_they_stop) {
    RunDescription run = with_method(describe("chain"), "euler");
    run.dt = 2;
    Simulation straight(run);
    straight.advance(2000);
    ASSERT_TRUE(straight.divergence());
    for (const std::uint64_t every : {1U, 7U, 100U, 300U, 2000U}) {
        Simulation stopped(run);
        const std::vector<std::uint64_t> at = stops(stopped, 2000, every);
        ASSERT_TRUE(stopped.divergence()) << every;
        EXPECT_EQ(stopped.divergence()->step, straight.divergence()->step) << every;
        EXPECT_EQ(stopped.hash(), straight.hash()) << every;
        EXPECT_EQ(*std::max_element(at.begin(), at.end()), straight.step()) << "no stop lies beyond it";
    }
}

// A bullet that lands on its target: there the energy of the pair is enormous, but no force acts, and the next step
// carries it through.
TEST(PlausibleSteps, come_back_where_the_next_check_finds_no_fault) {
    RunDescription run = with_method(describe("morse"), "euler");
    run.dt = 10;
    run.scene.set("edge", 1);
    run.scene.set("k", 20000);
    Simulation straight(run), stopped(run);
    straight.advance(1);
    ASSERT_FALSE(straight.is_plausible());
    PlausibleSteps steps(2000, [](std::uint64_t) {});
    steps.advance(stopped, 1);
    EXPECT_FALSE(stopped.divergence());
    EXPECT_EQ(stopped.step(), 1u);
    EXPECT_EQ(stopped.hash(), straight.hash());
    straight.advance(299);
    steps.advance(stopped, 300);
    EXPECT_EQ(stopped.hash(), straight.hash());
}

}  // namespace
}  // namespace steplab
