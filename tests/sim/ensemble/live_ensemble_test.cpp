#include "sim/ensemble/live_ensemble.hpp"

#include "core/error.hpp"
#include "sim/catalogue.hpp"
#include "support/runs.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace steplab {
namespace {

using test::MethodCase;
constexpr std::size_t count = 11;  // fills no register
LiveEnsemble::Variation spread(const LiveEnsembleOptions& ensemble) {
    return [ensemble](const RunDescription& description, std::size_t i) {
        return run_in_range(description, std::vector{range_of(ensemble, description)}, i, ensemble.runs);
    };
}

/// A run and the members of it, to which the same is done.
struct Flock {
    Simulation run;
    std::vector<SegmentBegin> segments;
    LiveEnsemble live_ensemble;
    std::vector<Simulation> alone;  ///< what the members are to be

    Flock(const RunDescription& description, const LiveEnsembleOptions& wanted)
        : run(description), segments{{0, description}}, live_ensemble(wanted.runs, spread(wanted)), ensemble(wanted) {
        for (std::size_t i = 0; i < ensemble.runs; ++i) alone.emplace_back(spread(ensemble)(description, i));
    }

    void advance(std::uint64_t steps) {
        run.advance(steps);
        for (Simulation& simulation : alone) simulation.advance(steps);
    }
    void change(const RunDescription& description) {
        segments.push_back({run.step(), description});
        run.change(description);
        for (std::size_t i = 0; i < ensemble.runs; ++i) alone[i].change(spread(ensemble)(description, i));
    }
    void pull(std::size_t particle, Vec3 position) {
        const Pull pull{particle, position};
        const auto* const last = segments.back().act ? std::get_if<Pull>(&*segments.back().act) : nullptr;
        if (last && last->particle == particle && segments.back().step == run.step()) segments.pop_back();
        segments.push_back({run.step(), run.description(), pull});
        run.act(pull);
        for (Simulation& simulation : alone) simulation.act(pull);
    }
    void act(const Act& act) {
        segments.push_back({run.step(), run.description(), act});
        run.act(act);
        for (Simulation& simulation : alone) simulation.act(act);
    }
    EnsembleSpread observe(Frame& frame) {
        EXPECT_TRUE(live_ensemble.go_to(run.step(), segments));
        EXPECT_TRUE(live_ensemble.are_at(run.step(), segments));
        run.frame(frame);
        return live_ensemble.observe(frame);
    }
    void expect_the_bits_of_runs_alone() {
        Frame frame;
        observe(frame);
        for (std::size_t i = 0; i < ensemble.runs; ++i) {
            const auto begin = frame.ensemble.begin() + static_cast<std::ptrdiff_t>(i * run.particles());
            const std::vector<Vec3> places(begin, begin + static_cast<std::ptrdiff_t>(run.particles()));
            ASSERT_EQ(places, alone[i].frame().positions) << "member " << i << " at step " << run.step();
        }
    }

    LiveEnsembleOptions ensemble;
};

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
