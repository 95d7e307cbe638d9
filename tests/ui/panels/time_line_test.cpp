#include "ui/desk.hpp"

#include <gtest/gtest.h>

#include <utility>
#include <variant>
#include <vector>

namespace steplab::ui {
namespace {

/// A run that stands at 8 s of 10 s.
void stand(Desk& desk, std::vector<TimeLineView::Branch> branches) {
    desk.view.frame.time = 8;
    desk.session.line = {.reached = 100, .reached_time = 10, .branches = std::move(branches)};
    desk.frame();
    desk.frame();
}

TEST(TimeLinePanel, has_room_for_a_way_that_was_left_where_the_present_one_ends) {
    Desk desk;
    stand(desk, {{10, 11}, {10, 1000}});
    const WidgetRect track = desk.widget("time");
    const auto width = [&](const char* widget) {
        const WidgetRect place = desk.widget(widget);
        return (place.right - place.left) / (track.right - track.left);
    };
    EXPECT_NEAR(width("branch 0"), 1 / 12.5, 0.02);  // the knob needs some pixels at both ends
    EXPECT_NEAR(width("branch 1"), 2.5 / 12.5, 0.02) << "a longer one than there is room for";
    stand(desk, {{2, 6}});
    EXPECT_NEAR(width("branch 0"), 0.4, 0.02) << "all of the track";
}

TEST(TimeLinePanel, is_dragged_no_farther_than_the_run_has_got) {
    Desk desk;
    stand(desk, {{10, 1000}});
    desk.calls();
    desk.drag("time", 0.7f, 0.97f);
    const auto* const seek = std::get_if<event::SeekTime>(&desk.recorder.events.back());
    ASSERT_NE(seek, nullptr);
    EXPECT_EQ(seek->time, 10);
}

}  // namespace
}  // namespace steplab::ui
