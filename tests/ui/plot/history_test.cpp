#include "ui/plot/history.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace steplab::ui {
namespace {

RunView moment(std::uint64_t step, Vec3 displacement = {}, std::uint64_t run = 0, std::size_t particle = 3) {
    RunView view;
    view.frame.step = step;
    view.frame.time = 0.1 * static_cast<double>(step);
    view.diagnostics.max_displacement = length(displacement);
    view.run = run;
    view.tracked = Tracked{particle, displacement, displacement};
    return view;
}

TEST(history, what_was_taken_back_counts_no_longer_as_reached) {
    History history;
    history.record(moment(1, {1, 0, 0}));
    history.record(moment(2, {1e100, 0, 0}));
    EXPECT_EQ(history.largest_displacement(), 1e100);
    history.record(moment(1, {1, 0, 0}));
    EXPECT_EQ(history.largest_displacement(), 1);
}

TEST(history, the_largest_error_so_far_is_kept) {
    History history;
    const auto record = [&](std::uint64_t step, std::optional<double> error) {
        RunView view = moment(step);
        view.diagnostics.error = error;
        history.record(view);
    };
    record(0, 0);
    record(1, 0.5);
    record(2, 1e-3);
    EXPECT_EQ(history.largest_error(), 0.5);
    record(1, 0.25);
    EXPECT_EQ(history.largest_error(), 0.25) << "what was taken back counts no longer";
    for (std::uint64_t step = 2; step < 50000; ++step) record(step, step == 777 ? 2 : 1e-3);
    EXPECT_EQ(history.largest_error(), 2) << "also where moments are left out";
    record(50000, std::nullopt);
    EXPECT_EQ(history.largest_error(), 2);
}

Sample sample_with(std::uint64_t step, double displacement, double error) {
    Sample sample;
    sample.step = step;
    sample.largest_displacement = displacement;
    sample.error = error;
    return sample;
}

/// A history of the steps of a run that are shown, of which the errors at all steps are sampled or not.
History shown_every(std::uint64_t steps, bool sampled) {
    History history;
    RunView view;
    for (std::uint64_t step = 0; step <= 60; ++step) {
        const double error = 1e-3 * static_cast<double>(step * 7919 % 61);
        if (sampled) view.series.samples.push_back(sample_with(step, 10 * error, error));
        view.frame.step = step;
        view.diagnostics.error = error;
        view.diagnostics.max_displacement = 10 * error;
        if (step % steps == 0) history.record(view);
    }
    return history;
}

TEST(history, the_largest_error_does_not_depend_on_the_playing_speed_where_there_are_samples) {
    for (const std::uint64_t steps : {1u, 4u, 15u, 60u}) {
        EXPECT_EQ(shown_every(steps, true).largest_error(), 0.06) << steps;
        EXPECT_EQ(shown_every(steps, true).largest_displacement(), 0.6) << steps;
    }
    EXPECT_LT(shown_every(60, false).largest_error(), 0.06) << "views alone do not see it";
}

TEST(history, samples_ahead_of_a_step_taken_back_do_not_count) {
    History history;
    RunView view = moment(2);
    for (const std::uint64_t step : {0u, 1u, 2u})
        view.series.samples.push_back(sample_with(step, 1, static_cast<double>(step)));
    history.record(view);
    EXPECT_EQ(history.largest_error(), 2);
    view.frame.step = 1;
    history.record(view);
    EXPECT_EQ(history.largest_error(), 1);
}

TEST(history, a_new_run_forgets_the_one_before) {
    History history;
    history.record(moment(7, {5, 0, 0}, 0));
    history.record(moment(0, {}, 1));
    EXPECT_EQ(history.largest_displacement(), 0);
}

TEST(history, the_plotted_direction_is_the_one_that_moves_most) {
    History history;
    history.record(moment(0, {0, 0.1, 0}));
    EXPECT_EQ(history.direction(), 1);
    history.record(moment(1, {0.11, 0.1, 0}));
    EXPECT_EQ(history.direction(), 1) << "directions of similar size do not alternate";
    history.record(moment(2, {-3, 0.1, 0}));
    EXPECT_EQ(history.direction(), 0);
    history.record(moment(3, {0, 0, 9}));
    EXPECT_EQ(history.direction(), 2);
    history.record(moment(4, {0, 0.1, 0}, 0, 8));
    EXPECT_EQ(history.direction(), 1) << "of another particle";
}

TEST(history, the_plotted_direction_of_a_particle_that_has_not_moved_is_that_of_its_velocity) {
    for (const auto& [velocity, direction] : {std::pair{Vec3{2, 0, 0}, 0}, {{0, -1, 0}, 1}, {{0, 1, 5}, 2}, {{}, 1}}) {
        History history;
        RunView start = moment(0, {});
        start.frame.velocities.assign(start.tracked->particle + 1, velocity);
        history.record(start);
        EXPECT_EQ(history.direction(), direction);
        history.record(moment(1, {0, 0, 0.5}));
        EXPECT_EQ(history.direction(), 2) << "where it went";
    }
}

TEST(history, the_plotted_direction_follows_from_the_samples_where_there_are_some) {
    History often, seldom;
    RunView view = moment(0);
    const auto add = [&](std::uint64_t step, Vec3 displacement) {
        const SampleSeries before = view.series;
        view = moment(step, {0, 0, 9e9});  // what views say does not count then
        view.series = before;
        Sample sample;
        sample.step = step;
        sample.particles = {Sample::Particle{displacement, {}}};
        view.series.samples.push_back(sample);
    };
    add(0, {0, 0.1, 0});
    often.record(view);
    add(1, {0.15, 0.1, 0});
    often.record(view);
    EXPECT_EQ(often.direction(), 0);
    add(2, {0.15, 0.17, 0});
    often.record(view);
    seldom.record(view);
    EXPECT_EQ(often.direction(), 0) << "1 is not clearly ahead";
    EXPECT_EQ(seldom.direction(), often.direction());
}

}  // namespace
}  // namespace steplab::ui
