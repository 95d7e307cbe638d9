#include "core/error.hpp"
#include "sim/catalogue.hpp"
#include "sim/ensemble/live_ensemble_test.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace steplab {
namespace {

using test::count;
using test::Flock;
using test::spread;

TEST(LiveEnsemble, that_do_not_differ_stay_where_the_run_is) {
    for (const Precision precision : test::precisions) {
        for (const char* const method : {"velocity-verlet", "rk4"}) {
            Flock flock(test::run_of("morse", method, precision, 0.01), {.runs = count, .width = 0});
            flock.advance(1000);
            Frame frame;
            const EnsembleSpread reading = flock.observe(frame);
            EXPECT_EQ(reading.largest, 0);
            EXPECT_EQ(reading.root_mean_square, 0);
            for (std::size_t i = 0; i < frame.ensemble.size(); ++i)
                ASSERT_EQ(frame.ensemble[i], frame.positions[i % frame.positions.size()]);
            // The check above can fail: the least difference shows.
            Flock other(test::run_of("morse", method, precision, 0.01), {.runs = count, .width = 1e-6});
            other.advance(1000);
            EXPECT_GT(other.observe(frame).root_mean_square, 0);
        }
    }
}

/// How much farther from the run the members are at the end than after a first time.
double growth(const RunDescription& description, double first, double end) {
    Flock flock(description, {.runs = 16, .spread = "v0", .width = 1e-6});
    Frame frame;
    flock.run.advance(steps_until(first, description.dt));
    const double early = flock.observe(frame).root_mean_square;
    flock.run.advance(steps_until(end - first, description.dt));
    return flock.observe(frame).root_mean_square / early;
}

TEST(LiveEnsemble, swell_in_chaos_alone) {
    // In the chain, which is linear along itself, a difference of the kick stays in proportion to the motion itself.
    // The bullet's errors grow by a factor of e within about a unit of time while it is inside the cluster.
    EXPECT_LT(growth(test::run_of("chain", "velocity-verlet", Precision::double_, 0.01), 1, 30), 10);
    EXPECT_GT(growth(test::run_of("morse", "velocity-verlet", Precision::double_, 0.01), 1, 30), 1000);
}

TEST(LiveEnsemble, that_are_lost_are_left_out) {
    // The stability limits are 1.01 and 1.43; the largest dt of the members is 1.95 times that of the run. Springs
    // of rest length 0 are linear: beyond the limit nothing holds the particles.
    for (const auto& [method, dt] : {std::pair("velocity-verlet", 0.55), std::pair("rk4", 0.8)}) {
        const RunDescription description = test::run_of("chain", method, Precision::double_, dt, {{"L", 0}});
        Flock flock(description, {.runs = 16, .spread = "dt", .width = 0.95});
        flock.run.advance(20000);
        ASSERT_FALSE(flock.run.divergence());
        Frame frame;
        const EnsembleSpread reading = flock.observe(frame);
        EXPECT_GT(reading.lost, 0u);
        EXPECT_LT(reading.lost, 8u);
        EXPECT_TRUE(std::isfinite(reading.largest));
        EXPECT_TRUE(std::isnan(frame.ensemble.back().x)) << "the one with the largest dt";
        EXPECT_TRUE(std::isfinite(frame.ensemble.front().x));
        // They stay lost in a segment that begins after it.
        flock.change(with_method(description, "euler"));
        EXPECT_EQ(flock.observe(frame).lost, reading.lost);
        EXPECT_TRUE(std::isnan(frame.ensemble.back().x));
    }
}

TEST(LiveEnsemble, too_many_or_of_other_sizes_are_refused) {
    const RunDescription mesh = test::run_of("mesh", "euler", Precision::double_, 0.1, {{"dim", 300}});
    Flock large(mesh, {.runs = 0});
    LiveEnsemble many(256, spread({.runs = 256}));
    EXPECT_THROW(many.go_to(0, large.segments), UsageError);
    const RunDescription chain = describe("chain", "euler");
    const std::vector<SegmentBegin> segments{{0, chain}};
    LiveEnsemble longer(2, [](RunDescription description, std::size_t i) {
        description.scene.set("n", 10.0 + static_cast<double>(i));
        return description;
    });
    EXPECT_THROW(longer.go_to(0, segments), UsageError);
}

TEST(LiveEnsemble, that_need_more_memory_than_there_is_are_refused) {
    // Thrown by the first member: those that are let through are not made.
    struct Begun {};
    const auto begin = [](const char* method) {
        // 1729 particles and all their pairs: the series of taylor take more than a GB in each run.
        const std::vector<SegmentBegin> segments{
            {0, test::run_of("morse", method, Precision::double_, 0.01, {{"edge", 12}})}};
        LiveEnsemble many(600, [](const RunDescription&, std::size_t) -> RunDescription { throw Begun(); });
        many.go_to(0, segments);
    };
    EXPECT_THROW(begin("velocity-verlet"), Begun) << "it is the method's memory";
    try {
        begin("taylor");
        ADD_FAILURE() << "no members were made";
    } catch (const UsageError& error) {
        EXPECT_THAT(error.what(), testing::ContainsRegex("needs [0-9.]+ ([kMGTP]B|bytes) of memory"));
        EXPECT_THAT(error.what(), testing::HasSubstr("runs at most"));
    }
}

}  // namespace
}  // namespace steplab
