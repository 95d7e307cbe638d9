#include "sim/run/simulation.hpp"

#include "core/error.hpp"
#include "core/flush_subnormals.hpp"
#include "support/runs.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <tuple>

namespace steplab::test {
namespace {

class EveryRun : public testing::TestWithParam<MethodCase> {
protected:
    RunDescription description(std::string_view model) const {
        return small_run_of(model, GetParam().id(), GetParam().precision, model == "rope" ? 0.01 : 0.05);
    }
};

TEST_P(EveryRun, gives_the_same_bits_however_its_steps_are_taken_and_looked_at) {
    for (const Model* const model : models_for(GetParam().id(), GetParam().precision)) {
        const bool slow = GetParam().info->implicit && model->info.id == "crystal";  // large linear systems
        const std::uint64_t pieces = slow ? 6 : 25;
        Simulation at_once(description(model->info.id)), in_pieces(description(model->info.id));
        at_once.advance(4 * pieces);
        for (std::uint64_t i = 0; i < pieces; ++i) {
            in_pieces.advance(4);
            in_pieces.frame();
            in_pieces.diagnostics();
        }
        EXPECT_EQ(at_once.hash(), in_pieces.hash()) << model->info.id;
        EXPECT_EQ(at_once.step(), in_pieces.step()) << model->info.id;
    }
}

TEST_P(EveryRun, goes_on_from_a_snapshot_with_the_same_bits) {
    for (const Model* const model : models_for(GetParam().id(), GetParam().precision)) {
        Simulation simulation(description(model->info.id));
        simulation.advance(20);
        const auto snapshot = simulation.save();
        const Frame then = simulation.frame();
        simulation.advance(30);
        const std::string hash = simulation.hash();
        const std::uint64_t evaluations = simulation.evaluations();
        simulation.restore(snapshot);
        EXPECT_EQ(simulation.frame().positions, then.positions) << model->info.id;
        EXPECT_EQ(simulation.frame().velocities, then.velocities) << model->info.id;
        simulation.advance(30);
        EXPECT_EQ(simulation.hash(), hash) << model->info.id;
        EXPECT_EQ(simulation.evaluations(), evaluations) << model->info.id;
    }
}

class EveryRunOfEqualSteps : public EveryRun {};

// Evaluations are the field's measure of cost: what the entry declares is what is counted.
TEST_P(EveryRunOfEqualSteps, costs_the_declared_evaluations) {
    Simulation simulation(description("mesh"));
    simulation.advance(1);
    const std::uint64_t first = simulation.evaluations();
    simulation.advance(1);
    const double a_step = evaluations_per_step(*GetParam().info, simulation.description().method_parameters);
    EXPECT_EQ(static_cast<double>(simulation.evaluations() - first), a_step);
    EXPECT_EQ(static_cast<double>(first) - a_step, GetParam().info->start_evaluations);
}

INSTANTIATE_TEST_SUITE_P(Catalogue, EveryRunOfEqualSteps, testing::ValuesIn(methods_where(has_equal_steps)), case_name);

TEST_P(EveryRun, shows_numbers_that_its_precision_holds) {
    for (const Model* const model : models_for(GetParam().id(), GetParam().precision)) {
        const Frame frame = frame_after(description(model->info.id), 17);
        for (const auto* vectors : {&frame.positions, &frame.velocities}) {
            for (const Vec3& v : *vectors) {
                for (const double number : {v.x, v.y, v.z}) EXPECT_EQ(rounded_to(frame.precision, number), number);
            }
        }
    }
}

// What a method makes of the start for its own use does not show; with drag it may round once or twice.
TEST_P(EveryRun, shows_the_start_as_it_was_given) {
    RunDescription kicked = description("chain");
    kicked.scene.set("c", 1);
    const Frame frame = Simulation(kicked).frame();
    EXPECT_NEAR(frame.velocities[9].x, 2, GetParam().precision == Precision::float_ ? 5e-7 : 1e-15);
    EXPECT_EQ(frame.velocities[8], Vec3{});
}

INSTANTIATE_TEST_SUITE_P(Catalogue, EveryRun, testing::ValuesIn(all_methods()), case_name);

/// The run of `description` from this synchronised state, by hand: a stepper of its own.
State<double> stepped(const RunDescription& description, const State<double>& start, std::uint64_t steps) {
    const FlushSubnormals flush;
    const Plan scene = model_of(description).plan(description.scene);
    const auto stepper = method(description.method)
                             .make({scene, start, description.method_parameters, description.precision,
                                    rounded_to(description.precision, description.dt)});
    stepper->advance(steps);
    State<double> state;
    stepper->synchronised(state);
    return state;
}

// Switching goes through the synchronised state and nothing else: a run switched to another method, precision and dt is
// the run of those from that state, bit by bit. All pairs, on scenes with and without drag.
TEST(Switching, in_mid_run_is_starting_from_that_state) {
    for (const Settings& settings : {Settings{}, Settings{{"c", 0.125}}}) {
        for (const MethodCase& from : all_methods()) {
            const RunDescription before = run_of("oscillator", from.id(), from.precision, 0.0625, settings);
            Simulation simulation(before);
            simulation.advance(10);
            ASSERT_FALSE(simulation.divergence()) << from;
            State<double> state{Field<double>(2), Field<double>(2)};
            state.displacement.set(1, simulation.frame().positions[1]);  // the oscillator's reference is the origin
            state.velocity.set(1, simulation.frame().velocities[1]);
            const auto moment = simulation.save();
            for (const MethodCase& to : all_methods()) {
                const RunDescription after = run_of("oscillator", to.id(), to.precision, 0.03125, settings);
                simulation.restore(moment);
                const Change change = simulation.change(after);
                EXPECT_EQ(change, after == before ? Change::none : Change::continued);
                EXPECT_EQ(simulation.step(), 10u);
                simulation.advance(10);
                ASSERT_FALSE(simulation.divergence()) << from << " to " << to;
                const State<double> expected = stepped(after, state, 10);
                EXPECT_EQ(simulation.frame().positions[1], expected.displacement.at(1)) << from << " to " << to;
                EXPECT_EQ(simulation.frame().velocities[1], expected.velocity.at(1)) << from << " to " << to;
                EXPECT_EQ(simulation.time(), 10 * 0.0625 + 10 * 0.03125);
                EXPECT_EQ(simulation.segment_start(), 10 * 0.0625);
            }
        }
    }
}

TEST(Switching, of_model_or_shape_restarts_and_of_a_live_parameter_does_not) {
    Simulation simulation(run_of("chain", "rk4", Precision::double_, 0.1));
    simulation.advance(5);
    RunDescription stiffer = simulation.description();
    stiffer.scene.set("k", 2);
    EXPECT_EQ(simulation.change(stiffer), Change::continued);
    EXPECT_EQ(simulation.step(), 5u);
    EXPECT_EQ(simulation.baseline_step(), 5u);
    EXPECT_EQ(simulation.diagnostics().energy_error, 0);
    EXPECT_FALSE(simulation.has_exact());
    RunDescription longer = stiffer;
    longer.scene.set("n", 12);
    EXPECT_EQ(simulation.change(longer), Change::restarted);
    EXPECT_EQ(simulation.step(), 0u);
    EXPECT_EQ(simulation.particles(), 12u);
    EXPECT_TRUE(simulation.has_exact());
    EXPECT_EQ(simulation.change(with_model(longer, "rope")), Change::restarted);
}

TEST(Switching, of_the_method_keeps_the_baseline_of_energy_and_the_exact_solution) {
    Simulation simulation(run_of("chain", "euler", Precision::double_, 0.1));
    simulation.advance(50);
    const double error = simulation.diagnostics().energy_error;
    EXPECT_EQ(simulation.change(with_method(simulation.description(), "rk4")), Change::continued);
    EXPECT_EQ(simulation.diagnostics().energy_error, error);
    EXPECT_TRUE(simulation.has_exact());
    EXPECT_EQ(simulation.baseline_step(), 0u);
}

TEST(Switching, to_what_cannot_be_run_leaves_the_run_as_it_was) {
    Simulation simulation(run_of("chain", "rk4", Precision::double_, 0.1));
    simulation.advance(5);
    const std::string hash = simulation.hash();
    RunDescription wrong = simulation.description();
    wrong.dt = 0;
    EXPECT_THROW(simulation.change(wrong), UsageError);
    EXPECT_EQ(simulation.hash(), hash);
    simulation.advance(1);
    EXPECT_EQ(simulation.step(), 6u);
}

TEST(Snapshot, leads_back_into_the_segment_before) {
    Simulation simulation(run_of("chain", "verlet", Precision::float_, 0.1));
    simulation.advance(7);
    const auto moment = simulation.save();
    simulation.advance(3);
    const std::string hash = simulation.hash();
    RunDescription other = with_method(simulation.description(), "rk4");
    other.scene.set("k", 3);
    simulation.change(other);
    simulation.advance(10);
    simulation.restore(moment);
    EXPECT_EQ(simulation.description().method, "verlet");
    EXPECT_TRUE(simulation.has_exact());
    simulation.advance(3);
    EXPECT_EQ(simulation.hash(), hash);
}

TEST(Pull, takes_a_particle_along_and_begins_a_new_baseline) {
    Simulation simulation(run_of("mesh", "rk4", Precision::double_, 0.1));
    simulation.advance(3);
    simulation.act(Pull{44, {8, 1, -8}});
    EXPECT_EQ(simulation.frame().positions[44], (Vec3{8, 1, -8}));
    EXPECT_EQ(simulation.frame().velocities[44], Vec3{});
    EXPECT_EQ(simulation.diagnostics().energy_error, 0);
    EXPECT_EQ(simulation.baseline_step(), 3u);
    simulation.act(Pull{0, {5, 5, 5}});  // fixed
    EXPECT_EQ(simulation.frame().positions[0], Vec3{});
}

TEST(Restart, begins_anew_with_the_present_description) {
    Simulation simulation(run_of("chain", "rk4", Precision::double_, 0.1));
    const std::string start = simulation.hash();
    simulation.advance(5);
    simulation.restart();
    EXPECT_EQ(simulation.hash(), start);
    EXPECT_EQ(simulation.evaluations(), 0u);
    simulation.advance(5);
    simulation.restart();
    EXPECT_EQ(simulation.hash(), start);
}

TEST(Time, is_counted_in_whole_steps_not_added_up) {
    Simulation simulation(run_of("oscillator", "euler", Precision::float_, 0.01));
    simulation.advance(1000000);
    EXPECT_EQ(simulation.time(), 1000000 * static_cast<double>(0.01f));
}

TEST(Diagnostics, add_up) {
    Simulation simulation(run_of("chain", "rk4", Precision::double_, 0.1, {{"fixed", 0}}));
    const Diagnostics start = simulation.diagnostics();
    EXPECT_EQ(start.kinetic, 2);
    EXPECT_EQ(start.potential, 0);
    EXPECT_EQ(start.momentum, (Vec3{2, 0, 0}));
    EXPECT_EQ(start.max_speed, 2);
    EXPECT_EQ(start.max_displacement, 0);
    simulation.advance(10);
    const Diagnostics later = simulation.diagnostics();
    EXPECT_EQ(later.energy, later.kinetic + later.potential);
    EXPECT_EQ(later.energy_error, later.energy - start.energy);
    EXPECT_GT(later.max_displacement, 0.5);
    EXPECT_LT(*later.error, 1e-5);  // rk4's error at dt = 0.1
}

// Whoever pulls grasps what he saw, and that is finite.
TEST(Pull, of_a_run_that_has_diverged_unseen_begins_at_the_last_good_step) {
    const RunDescription description = run_of("chain", "velocity-verlet", Precision::float_, 2);
    Simulation seen(description), unseen(description);
    for (Simulation* const simulation : {&seen, &unseen}) simulation->advance(20);
    ASSERT_TRUE(seen.divergence());
    for (Simulation* const simulation : {&seen, &unseen}) simulation->act(Pull{5, {10, 1, 0}});
    EXPECT_EQ(unseen.step(), seen.step());
    EXPECT_EQ(distance(unseen.frame(), seen.frame()), 0);
    EXPECT_TRUE(std::isfinite(unseen.energy()));
}

// Asked after every few steps, so it must cost nothing.
TEST(Advanced, tells_how_far_steps_were_taken_and_looks_at_no_particle) {
    Simulation simulation(run_of("chain", "velocity-verlet", Precision::float_, 2));
    simulation.advance(20);
    EXPECT_EQ(simulation.advanced().step, 20u);
    EXPECT_FALSE(simulation.advanced().diverged);
    const std::uint64_t good = simulation.step();
    EXPECT_LT(good, 20u);
    EXPECT_EQ(simulation.advanced().step, good);
    EXPECT_TRUE(simulation.advanced().diverged);
}

TEST(Diagnostics, know_angular_momentum_and_gravity) {
    Simulation mesh(run_of("mesh", "rk4", Precision::double_, 0.1));
    EXPECT_EQ(mesh.diagnostics().angular_momentum, (Vec3{10, 0, 10}));  // (10, 0, -10) x (0, 1, 0)
    Simulation rope(run_of("rope", "rk4", Precision::double_, 0.01));
    rope.advance(100);
    EXPECT_LT(rope.diagnostics().potential, 0);
    EXPECT_LT(rope.diagnostics().energy_error, 0);  // drag takes energy away
}

TEST(LargeScenes, run_with_a_million_particles) {
    for (const auto& [id, name, value] :
         {std::tuple{"free", "n", 1e6}, {"chain", "n", 1e6}, {"mesh", "dim", 1e3}, {"rope", "n", 1e6}}) {
        Simulation simulation(run_of(id, "euler", Precision::float_, 0.01, {{name, value}}));
        simulation.advance(2);
        EXPECT_EQ(simulation.step(), 2u) << id;
        EXPECT_EQ(simulation.particles(), 1000000u) << id;
        EXPECT_GT(simulation.diagnostics().max_displacement, 0) << id;
    }
}

TEST(LargeScenes, run_with_a_morse_cube_of_edge_20) {
    Simulation simulation(run_of("morse", "euler", Precision::float_, 0.01, {{"edge", 20}}));
    simulation.advance(1);
    EXPECT_EQ(simulation.step(), 1u);
    EXPECT_EQ(simulation.particles(), 8001u);
}

// Two ways from one moment, each with a segment of its own behind it.
TEST(Snapshots, of_a_way_that_was_left_are_not_taken_for_those_of_another) {
    Simulation simulation(run_of("chain", "rk4", Precision::double_, 0.1));
    simulation.advance(10);
    const Simulation::Snapshot fork = simulation.save();
    RunDescription one = simulation.description(), other = one;
    one.dt = 0.2;
    other.dt = 0.3;
    simulation.change(one);
    simulation.advance(5);
    const Simulation::Snapshot left = simulation.save();
    simulation.advance(5);
    const std::string right = simulation.hash();
    simulation.restore(fork);
    simulation.change(other);
    simulation.advance(5);
    simulation.restore(left);
    EXPECT_EQ(simulation.description().dt, 0.2);
    simulation.advance(5);
    EXPECT_EQ(simulation.hash(), right);
}

}  // namespace
}  // namespace steplab::test
