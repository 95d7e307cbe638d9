#include "sim/steppers/bands.hpp"

#include "sim/run/energy.hpp"
#include "support/no_threads.hpp"
#include "support/runs.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <any>
#include <memory>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace steplab::test {
namespace {

Execution by_threads(std::size_t count) { return {.threads = count, .particles_a_thread = 1}; }

/// Chains, ropes and grids that are cut unevenly, whatever the number of threads.
std::vector<RunDescription> runs_in_bands(const MethodCase& c) {
    std::vector<RunDescription> runs{run_of("chain", c.info->id, c.precision, 0.1, {{"n", 331}, {"c", 0.2}}),
                                     run_of("chain", c.info->id, c.precision, 0.1, {{"n", 150}, {"fixed", 0}}),
                                     run_of("rope", c.info->id, c.precision, 0.005, {{"n", 129}}),
                                     run_of("mesh", c.info->id, c.precision, 0.1, {{"dim", 61}}),
                                     run_of("mesh", c.info->id, c.precision, 0.1, {{"dim", 45}, {"v0", 30}})};
    for (std::size_t i = 0; i < 5; i += 3) {
        if (!runs[i].method_parameters.contains("compensated")) continue;
        runs.push_back(runs[i]);
        runs.back().method_parameters.set("compensated", 1);
    }
    return runs;
}

class Bands : public testing::TestWithParam<MethodCase> {};

// What is wrong at the ends of a band comes in by one spring an evaluation: 100 steps are enough for it to be seen, in
// a run whose particles all move from early on.
TEST_P(Bands, step_every_particle_as_one_thread_does) {
    for (const RunDescription& run : runs_in_bands(GetParam())) {
        Simulation one(run, by_threads(1));
        one.advance(100);
        for (const std::size_t threads : {2U, 3U, 5U}) {
            Simulation several(run, by_threads(threads));
            several.advance(41);
            several.advance(59);
            EXPECT_EQ(several.hash(), one.hash()) << run.model << " by " << threads;
            EXPECT_EQ(several.energy(), one.energy()) << run.model << " by " << threads;
            EXPECT_EQ(several.evaluations(), one.evaluations());
        }
    }
}

TEST_P(Bands, step_every_particle_where_no_thread_can_be_started) {
    const NoThreads none;
    for (const RunDescription& run : runs_in_bands(GetParam())) {
        Simulation one(run, by_threads(1)), wanted_three(run, by_threads(3));
        for (Simulation* simulation : {&one, &wanted_three}) simulation->advance(30);
        EXPECT_EQ(wanted_three.hash(), one.hash()) << run.model;
    }
}

TEST_P(Bands, go_on_from_a_kept_moment) {
    for (const RunDescription& run : runs_in_bands(GetParam())) {
        Simulation simulation(run, by_threads(3));
        simulation.advance(20);
        const auto moment = simulation.save();
        simulation.advance(30);
        const std::string hash = simulation.hash();
        simulation.restore(moment);
        EXPECT_EQ(simulation.step(), 20u);
        simulation.advance(30);
        EXPECT_EQ(simulation.hash(), hash) << run.model;
    }
}

/// Those whose steps reach only so far.
std::vector<MethodCase> local_methods() {
    const Plan chain = model("chain").plan(describe("chain").scene);
    std::vector<MethodCase> cases;
    for (const MethodCase& c : all_methods()) {
        const Method& entry = method(c.info->id);
        const auto stepper = entry.make({chain, chain.start, ParameterValues(c.info->parameters), c.precision, 0.1});
        if (stepper->reach()) cases.push_back(c);
    }
    return cases;
}

TEST(LocalMethods, are_the_explicit_ones_of_fixed_steps) {
    std::set<std::string_view> found;
    for (const MethodCase& c : local_methods()) found.insert(c.info->id);
    EXPECT_EQ(found, (std::set<std::string_view>{"euler", "midpoint", "rk4", "stoermer", "verlet", "velocity-verlet",
                                                 "forest-ruth", "pefrl", "mclachlan-atela-5", "srkn-11b", "kahan-li-8",
                                                 "euler-forward"}));
}

INSTANTIATE_TEST_SUITE_P(Catalogue, Bands, testing::ValuesIn(local_methods()), case_name);

// A wave that has passed all borders, on a mesh large enough for several steps between two meetings.
TEST(LargeBands, meet_only_every_few_steps) {
    for (const char* method : {"velocity-verlet", "midpoint"}) {
        const RunDescription run = run_of("mesh", method, Precision::float_, 0.5, {{"dim", 420}, {"v0", 100}});
        Simulation one(run, by_threads(1)), two(run, by_threads(2));
        one.advance(40);
        two.advance(40);
        EXPECT_EQ(one.hash(), two.hash()) << method;
    }
}

// Of so many particles that they are summed in several pieces, some of which lie in two bands; in few bands meshes take
// more than a core's cache and go many sweeps together, in many bands one sweep at a time.
TEST(LargeBands, look_as_one_thread_does) {
    for (const Precision precision : {Precision::double_, Precision::float_}) {
        for (const RunDescription& run :
             {run_of("chain", "rk4", precision, 0.1, {{"n", 30011}, {"c", 0.2}}),
              run_of("mesh", "rk4", precision, 0.1, {{"dim", 167}, {"v0", 30}}),
              run_of("mesh", "velocity-verlet", precision, 0.1, {{"dim", 230}, {"v0", 30}})}) {
            Simulation one(run, by_threads(1));
            one.advance(30);
            Frame expected, frame;
            const Diagnostics right = one.observe(expected);
            for (const std::size_t threads : {2U, 3U, 5U, 11U}) {
                Simulation several(run, by_threads(threads));
                several.advance(30);
                const Diagnostics found = several.observe(frame);
                EXPECT_EQ(frame.positions, expected.positions) << run.model << " by " << threads;
                EXPECT_EQ(frame.velocities, expected.velocities);
                EXPECT_EQ(found.energy, right.energy);
                EXPECT_EQ(found.kinetic, right.kinetic);
                EXPECT_EQ(found.momentum, right.momentum);
                EXPECT_EQ(found.angular_momentum, right.angular_momentum);
                EXPECT_EQ(found.max_displacement, right.max_displacement);
                EXPECT_EQ(found.max_speed, right.max_speed);
            }
        }
    }
}

// Bands leave out the axes along which nothing moves, each by itself, until what is pulled sideways at one end comes
// over their borders; with moments from before and after to go back to.
TEST(LargeBands, move_along_the_axes_of_their_neighbours) {
    const RunDescription run = run_of("chain", "velocity-verlet", Precision::double_, 0.5, {{"n", 60}});
    const auto pulled = [&](std::size_t threads) {
        Simulation simulation(run, by_threads(threads));
        simulation.advance(10);
        simulation.act(Pull{59, {150, 30, 20}});
        return simulation;
    };
    const auto expect_hash = [&](Simulation& several, std::uint64_t steps) {
        Simulation one = pulled(1);
        one.advance(steps);
        EXPECT_EQ(several.hash(), one.hash()) << steps;
        EXPECT_EQ(one.frame().positions[1].y != 0, steps >= 400) << steps;
    };
    for (const std::size_t threads : {2U, 5U}) {
        Simulation several = pulled(threads);
        const auto before = several.save();
        several.advance(20);
        expect_hash(several, 20);
        several.advance(380);
        expect_hash(several, 400);
        const auto after = several.save();
        several.restore(before);
        several.advance(400);
        expect_hash(several, 400);
        several.restart();
        several.restore(after);
        several.advance(50);
        expect_hash(several, 450);
    }
}

/// A chain by so many threads.
std::unique_ptr<Stepper> chain_in_bands(const Plan& scene, std::string_view id, std::size_t threads) {
    const Method& entry = method(id);
    const ParameterValues parameters(entry.info.parameters);
    return make_stepper(entry, {scene, scene.start, parameters, Precision::double_, 0.1}, by_threads(threads));
}

// look() shows one part, whoever steps.
TEST(LargeBands, look_one_after_the_other_in_one_part) {
    const Plan scene = model("chain").plan(run_of("chain", "euler", Precision::double_, 0.1, {{"n", 9000}}).scene);
    const auto one = chain_in_bands(scene, "euler", 1), several = chain_in_bands(scene, "euler", 5);
    ASSERT_EQ(several->parts(), 5u);
    EnergyMeter meter(scene, fastest_instructions());
    const Energy right = meter.energy([&](const PortionSink& sink) { one->emit(sink); });
    const Energy found = meter.energy([&](const PortionSink& sink) { several->emit(sink); });
    EXPECT_EQ(found.kinetic, right.kinetic);
    EXPECT_EQ(found.total(), right.total());
    several->emit([](const Portion& portion) { EXPECT_EQ(portion.part, 0u); });
}

// The steps of one method reach further than those of the other, so it has fewer bands.
TEST(LargeBands, save_over_what_another_method_saved) {
    const Plan scene = model("chain").plan(run_of("chain", "euler", Precision::double_, 0.1, {{"n", 331}}).scene);
    const auto few = chain_in_bands(scene, "kahan-li-8", 16), many = chain_in_bands(scene, "euler", 16);
    ASSERT_LT(few->parts(), many->parts());
    std::any saved;
    for (const auto* stepper : {&few, &many, &few}) {
        (*stepper)->save(saved);
        State<double> before, after;
        (*stepper)->synchronised(before);
        (*stepper)->advance(10);
        (*stepper)->restore(saved);
        (*stepper)->synchronised(after);
        EXPECT_TRUE(std::ranges::equal(after.displacement.flat(), before.displacement.flat()));
        EXPECT_TRUE(std::ranges::equal(after.velocity.flat(), before.velocity.flat()));
    }
}

TEST(LargeBands, diverge_at_the_step_and_particle_at_which_one_thread_does) {
    const RunDescription run = run_of("mesh", "rk4", Precision::double_, 1.1, {{"dim", 60}, {"v0", 10}});
    Simulation one(run, by_threads(1)), three(run, by_threads(3));
    one.advance(2000);
    three.advance(2000);
    ASSERT_TRUE(one.divergence() && three.divergence());
    EXPECT_EQ(one.divergence()->step, three.divergence()->step);
    EXPECT_EQ(one.divergence()->particle, three.divergence()->particle);
    EXPECT_EQ(one.hash(), three.hash());
}

// Lists are made anew several times; a drop without a period, of a size that is cut unevenly.
TEST(LargePairs, are_summed_by_several_threads_as_by_one) {
    for (const Precision precision : {Precision::double_, Precision::float_}) {
        for (const RunDescription& run :
             {run_of("crystal", "velocity-verlet", precision, 0.01, {{"edge", 19}, {"m", 1}}),
              run_of("morse", "velocity-verlet", precision, 0.01, {{"edge", 17}, {"cutoff", 2}, {"spacing", 0.9}})}) {
            Simulation one(run, by_threads(1));
            one.advance(40);
            for (const std::size_t threads : {2U, 3U, 7U}) {
                Simulation several(run, by_threads(threads));
                several.advance(17);
                several.restore(several.save());
                several.advance(23);
                EXPECT_EQ(several.hash(), one.hash()) << run.model << " by " << threads;
            }
        }
    }
}

}  // namespace
}  // namespace steplab::test
