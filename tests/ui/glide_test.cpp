#include "ui/glide.hpp"

#include <gtest/gtest.h>

namespace steplab::ui {
namespace {

using std::chrono::milliseconds;

constexpr Glide::Time start{};

/// The view of a run that plays at one second a second with dt = 0.1.
RunView view_at(std::uint64_t step) {
    RunView view;
    view.playing = true;
    view.frame.step = step;
    view.frame.time = 0.1 * static_cast<double>(step);
    view.frame.positions.resize(1);
    return view;
}

std::shared_ptr<const SessionView> session_of(const RunView& leading) {
    return std::make_shared<SessionView>(SessionView{.leading = leading});
}

/// A glide that has seen two views, the second one now.
Glide after(const RunView& before, const RunView& now) {
    Glide glide;
    glide.arrived(session_of(before), start - milliseconds(100));
    glide.arrived(session_of(now), start);
    return glide;
}

TEST(Glide, goes_from_step_to_step_in_the_time_between_them) {
    const Glide glide = after(view_at(4), view_at(5));
    EXPECT_EQ(glide.from(start)->leading.frame.step, 4u);
    EXPECT_EQ(glide.fraction(start), 0);
    EXPECT_NEAR(glide.fraction(start + milliseconds(50)), 0.5, 1e-9);  // the clock's nanoseconds
    EXPECT_FALSE(glide.gliding(start + milliseconds(101)));
    EXPECT_EQ(glide.from(start + milliseconds(101)), nullptr);
}

TEST(Glide, shows_the_newest_view_where_there_is_no_motion_between) {
    RunView paused = view_at(5);
    paused.playing = false;
    RunView restarted = view_at(5);
    restarted.run = 1;
    RunView fast = view_at(5);
    fast.rate.as_fast_as_possible = true;
    RunView quick = view_at(5);
    quick.rate.seconds_per_second = 10;
    RunView slow = view_at(5);
    slow.rate.seconds_per_second = 0.1;
    RunView pulled = view_at(5);
    pulled.smooth_since = 0.45;
    RunView crowd = view_at(5);
    crowd.frame.positions.resize(1000000);
    for (const RunView& view : {paused, restarted, fast, quick, slow, pulled, crowd, view_at(4), view_at(3)}) {
        EXPECT_FALSE(after(view_at(4), view).gliding(start));
    }
}

TEST(Glide, begins_with_the_second_view) {
    Glide glide;
    EXPECT_FALSE(glide.gliding(start));
    glide.arrived(session_of(view_at(0)), start);
    EXPECT_FALSE(glide.gliding(start));
}

}  // namespace
}  // namespace steplab::ui
