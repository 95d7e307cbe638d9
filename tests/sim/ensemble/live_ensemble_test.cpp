#include "sim/ensemble/live_ensemble_test.hpp"

#include "core/error.hpp"
#include "sim/catalogue.hpp"

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
using test::MethodCase;
using test::spread;

class LiveEnsembleOf : public testing::TestWithParam<MethodCase> {};

TEST_P(LiveEnsembleOf, each_method_have_the_bits_of_runs_alone) {
    for (const char* const model : {"chain", "rope", "mesh", "morse", "oscillator", "free"}) {
        for (const char* const name : {"v0", "k", "dt"}) {
            RunDescription description = test::run_of(model, GetParam().id(), GetParam().precision, 0.02);
            if (description.scene.contains("dim")) description.scene.set("dim", 4);
            if (description.scene.contains("edge")) description.scene.set("edge", 2);
            Flock flock(description, {.runs = count, .spread = name, .width = 0.1});
            SCOPED_TRACE(std::string(model) + " " + name);
            flock.advance(3);
            flock.expect_the_bits_of_runs_alone();
            flock.advance(40);
            flock.expect_the_bits_of_runs_alone();
        }
    }
}

TEST_P(LiveEnsembleOf, hands_on_particles_have_the_bits_of_runs_alone) {
    if (GetParam().info->curiosity) return;  // they refuse altered scenes
    for (const char* const model : {"chain", "morse"}) {
        const RunDescription description = test::run_of(model, GetParam().id(), GetParam().precision, 0.02);
        Flock flock(description, {.runs = 3, .spread = "k", .width = 0.1});
        SCOPED_TRACE(model);
        const auto alter = [&](const Alteration& alteration) {
            flock.change(with_alterations(flock.run.description(), std::vector{alteration}));
            flock.expect_the_bits_of_runs_alone();
            flock.advance(5);
            flock.expect_the_bits_of_runs_alone();
        };
        alter({9, true});
        alter({9, false});
        alter({5, std::nullopt, 2.5});
        for (int i = 0; i < 4; ++i) {
            flock.act(Tug{5, {1, 2, 0}, 3, i > 0, ParticleList({6, 7}), 0.1});
            flock.advance(5);
        }
        flock.expect_the_bits_of_runs_alone();
    }
}

INSTANTIATE_TEST_SUITE_P(Methods, LiveEnsembleOf, testing::ValuesIn(test::all_methods()), test::case_name);

/// Those without a tolerance: a jump of the force at the cutoff makes the steps of the others so small that this would
/// take seconds.
class LiveEnsembleWithoutToleranceOf : public testing::TestWithParam<MethodCase> {};

/// Where their sums depend on where the lists of neighbours were made.
TEST_P(LiveEnsembleWithoutToleranceOf, each_method_have_the_bits_of_runs_alone_with_a_cutoff) {
    using test::run_of;
    // Few but long steps of implicit methods, whose linear systems are large: in 30 short and in 5 long steps particles
    // of the crystal move by more than 0.144, and its lists are renewed.
    const bool few = GetParam().info->implicit;
    const std::uint64_t some = few ? 5 : 30;
    const double dt = few ? 0.1 : 0.02;
    for (RunDescription description :
         {run_of("crystal", GetParam().id(), GetParam().precision, dt, {{"edge", 5}, {"kT", 1}}),
          run_of("morse", GetParam().id(), GetParam().precision, dt, {{"edge", 2}, {"cutoff", 1}})}) {
        SCOPED_TRACE(description.model);
        Flock flock(description, {.runs = few ? 2u : 3u, .spread = "dt", .width = 0.1});
        flock.advance(some);
        flock.expect_the_bits_of_runs_alone();
        description.dt = 1.5 * dt;
        flock.change(description);
        flock.advance(some);
        Frame before, again;
        flock.observe(before);
        flock.advance(some);
        flock.expect_the_bits_of_runs_alone();
        // A step back within the segment, and one into the segment before.
        flock.run.frame(again);
        flock.live_ensemble.go_to(2 * some, flock.segments);
        flock.live_ensemble.observe(again);
        EXPECT_EQ(again.ensemble, before.ensemble);
        flock.live_ensemble.go_to(some / 2, flock.segments);
        flock.expect_the_bits_of_runs_alone();
    }
}

INSTANTIATE_TEST_SUITE_P(Methods, LiveEnsembleWithoutToleranceOf,
                         testing::ValuesIn(test::methods_where([](const MethodCase& it) {
                             return !ParameterValues(it.info->parameters).contains("tolerance");
                         })),
                         test::case_name);

TEST(LiveEnsemble, are_computed_in_lanes_where_the_method_goes_so) {
    const auto in_lanes = [](const char* model, const char* method) {
        Flock flock(describe(model, method), {.runs = 16});
        flock.live_ensemble.go_to(0, flock.segments);
        return flock.live_ensemble.in_lanes();
    };
    EXPECT_EQ(in_lanes("chain", "euler"), 16u);
    EXPECT_EQ(in_lanes("chain", "velocity-verlet"), 16u);
    EXPECT_EQ(in_lanes("mesh", "velocity-verlet"), 16u);
    EXPECT_EQ(in_lanes("chain", "dopri5"), 0u);
}
TEST(LiveEnsemble, have_everything_happen_to_them_that_happens_to_the_run) {
    for (const char* const method : {"velocity-verlet", "rk4"}) {
        const RunDescription description = test::run_of("chain", method, Precision::double_, 0.05);
        Flock flock(description, {.runs = count, .spread = "k", .width = 0.01});
        flock.pull(5, {6, 1, 0});
        flock.advance(300);
        RunDescription other = with_method(description, "euler");
        other.dt = 0.02;
        flock.change(other);
        flock.expect_the_bits_of_runs_alone();
        flock.advance(7);
        other.scene.set("k", 2);
        other.precision = Precision::float_;
        flock.change(other);
        flock.pull(2, {2, -1, 0});
        flock.advance(20);
        flock.expect_the_bits_of_runs_alone();
    }
}

TEST(LiveEnsemble, go_back_within_a_segment_and_beyond_it) {
    const RunDescription description = test::run_of("morse", "velocity-verlet", Precision::double_, 0.01);
    Flock flock(description, {.runs = count});
    flock.advance(100);
    flock.change(with_method(description, "euler"));
    flock.advance(50);
    Frame after, again;
    flock.observe(after);
    flock.live_ensemble.go_to(120, flock.segments);
    EXPECT_EQ(flock.live_ensemble.step(), 120u);
    flock.live_ensemble.go_to(30, flock.segments);
    EXPECT_EQ(flock.live_ensemble.step(), 30u);
    flock.observe(again);
    EXPECT_EQ(again.ensemble, after.ensemble);
}

TEST(LiveEnsemble, go_on_in_a_segment_that_begins_before_where_they_are) {
    const RunDescription description = test::run_of("morse", "velocity-verlet", Precision::double_, 0.01);
    Flock flock(description, {.runs = count});
    flock.live_ensemble.go_to(100, flock.segments);
    flock.advance(90);
    flock.change(with_method(description, "euler"));
    flock.advance(20);
    flock.expect_the_bits_of_runs_alone();
}

TEST(LiveEnsemble, stop_between_segments_without_steps_too) {
    Flock flock(test::run_of("chain", "euler", Precision::double_, 0.05), {.runs = count});
    flock.live_ensemble.go_to(0, flock.segments);
    for (std::size_t i = 0; i < 100; ++i) flock.pull(5 + i % 2, {10, 0.01 * static_cast<double>(i), 0});
    int asked = 0;
    EXPECT_FALSE(flock.live_ensemble.go_to(0, flock.segments, [&] { return ++asked > 0; }));
    EXPECT_EQ(asked, 1);
    EXPECT_FALSE(flock.live_ensemble.are_at(0, flock.segments));
    flock.advance(5);
    flock.expect_the_bits_of_runs_alone();
}

TEST(LiveEnsemble, are_dragged_along_in_one_segment) {
    for (const Precision precision : test::precisions) {
        Flock flock(test::run_of("morse", "velocity-verlet", precision, 0.01), {.runs = count, .width = 0.01});
        flock.advance(30);
        for (int i = 0; i < 100; ++i) {
            flock.pull(5, {1.3, 0.01 * i, 0.2});
            if (i % 20 == 0) flock.expect_the_bits_of_runs_alone();
        }
        EXPECT_EQ(flock.segments.size(), 2u);
        flock.expect_the_bits_of_runs_alone();
        // The last pull counts also where the members have gone on from an earlier one.
        flock.live_ensemble.go_to(40, flock.segments);
        flock.pull(5, {1.3, -0.5, 0.2});
        flock.advance(20);
        flock.expect_the_bits_of_runs_alone();
        flock.pull(5, {1.3, 0, 0});
        flock.pull(6, {1.3, 0, 0.4});
        EXPECT_EQ(flock.segments.size(), 4u) << "at another step, and another particle";
        flock.expect_the_bits_of_runs_alone();
    }
}

TEST(LiveEnsemble, stop_while_they_begin_and_go_on_later) {
    Flock flock(test::run_of("chain", "euler", Precision::double_, 0.05), {.runs = count});
    std::size_t calls = 1;
    while (!flock.live_ensemble.go_to(0, flock.segments, [asked = 0]() mutable { return ++asked > 2; })) {
        ASSERT_FALSE(flock.live_ensemble.are_at(0, flock.segments));
        ++calls;
    }
    EXPECT_EQ(calls, (count + 1) / 2) << "two of them in each call";
    flock.advance(7);
    flock.expect_the_bits_of_runs_alone();
}

TEST(LiveEnsemble, stop_on_the_way_and_go_on_later) {
    const RunDescription description = test::run_of("chain", "euler", Precision::double_, 0.05);
    Flock flock(description, {.runs = count});
    const std::uint64_t end = 1000000;
    int asked = 0;
    ASSERT_FALSE(flock.live_ensemble.go_to(end, flock.segments, [&] { return ++asked > 3 + static_cast<int>(count); }));
    EXPECT_GT(flock.live_ensemble.step(), 0u);
    EXPECT_LT(flock.live_ensemble.step(), end);
    EXPECT_FALSE(flock.live_ensemble.are_at(end, flock.segments));
    flock.advance(flock.live_ensemble.step() + 5);
    flock.expect_the_bits_of_runs_alone();
}

}  // namespace
}  // namespace steplab
