#include "lab/study/reference_motion.hpp"

#include "lab/study/distances.hpp"
#include "support/heap.hpp"
#include "support/runs.hpp"

#include <gtest/gtest.h>

#include <span>
#include <string>
#include <vector>

namespace steplab::test {
namespace {

std::vector<double> numbers(const ReferenceMoment& moment) {
    const auto flat = moment.state.displacement.flat();
    return {flat.begin(), flat.end()};
}

std::vector<RunDescription> scenes_without_a_closed_form() {
    return {scene_with("mesh", {{"dim", 5}}), scene_with("rope", {{"n", 5}}), scene_with("morse", {{"spacing", 0.3}}),
            scene_with("morse", {{"edge", 2}, {"cutoff", 2}}),
            scene_with("chain", {{"n", 4}, {"v0", 0.3}, {"fixed", 1}})};
}

// Two families of steps, equal ones and those of its own: each one's estimate is of its own error.
TEST(ReferenceMotion, agrees_with_the_reference_within_both_estimates) {
    for (const RunDescription& scene : scenes_without_a_closed_form()) {
        SCOPED_TRACE(command_line(scene));
        const std::vector<double> times{0.3, 1, 2};
        const Reference right = reference_run(scene, times);
        ReferenceMotion motion(scene);
        for (const ReferenceMoment& moment : right.moments) {
            const ReferenceMoment there = motion.at(moment.time);
            EXPECT_EQ(there.time, moment.time);
            EXPECT_LE(largest_distance(there.state.displacement, moment.state.displacement),
                      10 * (there.error + moment.error));
            EXPECT_LT(there.error, 1e-12) << "of tolerances of 1e-15 and 1e-17, over times of 2 s";
        }
    }
}

TEST(ReferenceMotion, says_the_same_of_a_time_whatever_it_was_asked_before) {
    for (const RunDescription& scene : scenes_without_a_closed_form()) {
        SCOPED_TRACE(command_line(scene));
        ReferenceMotion once(scene), often(scene);
        for (const double time : {0.1, 0.11, 0.7, 1.4, 1.5}) often.at(time);
        const ReferenceMoment right = once.at(1.5);
        EXPECT_EQ(numbers(often.at(1.5)), numbers(right));
        const ReferenceMoment early = often.at(0.2);  // back
        EXPECT_EQ(numbers(ReferenceMotion(scene).at(0.2)), numbers(early));
        EXPECT_EQ(often.at(1.5).error, right.error);
    }
}

TEST(ReferenceMotion, is_the_closed_form_where_there_is_one) {
    ReferenceMotion chain(scene_with("chain")), mesh(scene_with("mesh", {{"dim", 5}}));
    const Reference exact = reference(scene_with("chain"), std::vector<double>{68.1});
    EXPECT_EQ(numbers(chain.at(68.1)), numbers(exact.moments[0]));
    EXPECT_TRUE(chain.is_exact());
    EXPECT_EQ(chain.how(), "exact solution");
    mesh.at(1);
    EXPECT_FALSE(mesh.is_exact());
    EXPECT_NE(mesh.how().find("extrapolation"), std::string::npos);
}

// The partner: another scene is another motion.
TEST(ReferenceMotion, tells_scenes_apart) {
    ReferenceMotion one(scene_with("mesh", {{"dim", 5}})), other(scene_with("mesh", {{"dim", 5}, {"k", 1.01}}));
    const ReferenceMoment a = one.at(1), b = other.at(1);
    EXPECT_GT(largest_distance(a.state.displacement, b.state.displacement), 1e6 * (a.error + b.error));
}

/// A pull that is held: an impulse for each picture.
std::vector<SegmentBegin> held_pull(const RunDescription& scene, std::size_t impulses) {
    std::vector<SegmentBegin> changes{{0, scene}};
    for (std::size_t i = 1; i <= impulses; ++i) {
        const double time = 1e-3 * static_cast<double>(i);
        changes.push_back({i, scene, Kick{i % 7, {0.1, 0, 0.01 * static_cast<double>(i)}}, time});
    }
    return changes;
}

// 3600 particles: the states of two runs take 0.7 MB in long double, and all impulses 83 MB; 33.6 MB are kept, and as
// much again is what runs under way, the scene and its forces may take.
TEST(ReferenceMotion, keeps_its_memory_in_a_pull_that_is_held_for_long) {
    const RunDescription scene = scene_with("mesh", {{"dim", 60}});
    const auto changes = held_pull(scene, 120);
    const double before = heap();
    ReferenceMotion motion(scene);
    motion.follow(changes);
    EXPECT_LE(heap() - before, 67e6);
    // a time whose start is not kept any more is the same as one of which it is
    const std::span earlier = std::span(changes).first(62);
    ReferenceMotion fresh(scene);
    fresh.follow(earlier);
    EXPECT_EQ(numbers(motion.at(0.0615)), numbers(fresh.at(0.0615)));
    EXPECT_EQ(motion.at(0.0615).error, fresh.at(0.0615).error);
    motion.follow(earlier);
    EXPECT_EQ(numbers(motion.at(0.07)), numbers(fresh.at(0.07))) << "what came later is taken back";
}

}  // namespace
}  // namespace steplab::test
