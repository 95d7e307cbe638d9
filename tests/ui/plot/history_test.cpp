#include "ui/plot/history.hpp"

#include <gtest/gtest.h>

namespace steplab::ui {
namespace {

RunView moment(std::uint64_t step, Vec3 displacement = {}, std::uint64_t run = 0, std::size_t particle = 3) {
    RunView view;
    view.frame.step = step;
    view.frame.time = 0.1 * static_cast<double>(step);
    view.diagnostics.energy_error = -1e-3 * static_cast<double>(step);
    view.diagnostics.max_displacement = length(displacement);
    view.run = run;
    view.tracked = Tracked{particle, displacement, displacement};
    return view;
}

TEST(history, keeps_what_it_saw_in_order) {
    History history;
    for (std::uint64_t step = 0; step < 5; ++step) history.record(moment(step));
    ASSERT_EQ(history.whole().size(), 5u);
    EXPECT_DOUBLE_EQ(history.whole()[4].time, 0.4);
    EXPECT_DOUBLE_EQ(history.whole()[4].energy_error, 4e-3);
    EXPECT_EQ(history.recent().size(), 5u);
}

TEST(history, the_same_moment_twice_counts_once) {
    History history;
    history.record(moment(1));
    history.record(moment(1));
    EXPECT_EQ(history.whole().size(), 1u);
    EXPECT_EQ(history.recent().size(), 1u);
}

TEST(history, a_step_back_drops_what_came_after) {
    History history;
    for (std::uint64_t step = 0; step < 9; ++step) history.record(moment(step));
    history.record(moment(4));
    ASSERT_EQ(history.whole().size(), 5u);
    EXPECT_DOUBLE_EQ(history.whole().back().time, 0.4);
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
    EXPECT_EQ(history.largest_error(), 2) << "also where samples are left out";
    record(50000, std::nullopt);
    EXPECT_EQ(history.largest_error(), 2);
}

TEST(history, a_new_run_begins_anew) {
    History history;
    history.record(moment(7, {5, 0, 0}, 0));
    history.record(moment(0, {}, 1));
    EXPECT_EQ(history.whole().size(), 1u);
    EXPECT_EQ(history.largest_displacement(), 0);
}

TEST(history, memory_is_bounded_and_spans_the_whole_run) {
    History history;
    constexpr std::uint64_t last = 200000;
    for (std::uint64_t step = 0; step <= last; ++step) history.record(moment(step));
    EXPECT_LE(history.whole().size(), 8192u);
    EXPECT_GE(history.whole().size(), 2048u);
    EXPECT_EQ(history.whole().front().time, 0);
    EXPECT_GT(history.whole().back().time, 0.99 * 0.1 * last);
    EXPECT_EQ(history.recent().size(), 600u);
    EXPECT_DOUBLE_EQ(history.recent().back().time, 0.1 * last);
}

TEST(history, another_particle_forgets_the_path_but_not_the_energy) {
    History history;
    history.record(moment(0, {0, 1, 0}));
    history.record(moment(1, {0, 2, 0}, 0, 8));
    EXPECT_EQ(history.particle(), 8u);
    EXPECT_FALSE(history.whole()[0].displacement);
    EXPECT_TRUE(history.whole()[1].displacement);
    EXPECT_DOUBLE_EQ(history.whole()[1].energy_error, 1e-3);
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
}

}  // namespace
}  // namespace steplab::ui
