#include "ui/movement.hpp"

#include <gtest/gtest.h>

namespace steplab::ui {
namespace {

using std::chrono::milliseconds;

constexpr milliseconds frame{16}, slow_picture{800};

class MovementTest : public ::testing::Test {
protected:
    /// A frame that finds it moved, and requests another picture.
    void move(Movement::Time now) {
        movement_.seen(now);
        movement_.requested(now, true);
    }
    /// One that does not.
    void stand(Movement::Time now, bool another) { movement_.requested(now, another); }

    Movement movement_;
    const Movement::Time start_{milliseconds(5000)};
};

TEST_F(MovementTest, does_not_go_on_before_it_is_seen) {
    EXPECT_FALSE(movement_.goes_on(start_));
    movement_.pictured(start_, true, start_);
    EXPECT_FALSE(movement_.goes_on(start_)) << "a picture alone is no movement";
}

TEST_F(MovementTest, ends_a_while_after_its_picture) {
    move(start_);
    movement_.pictured(start_, false, start_ + frame);
    EXPECT_EQ(movement_.rest(), start_ + Movement::time_to_rest);
    EXPECT_TRUE(movement_.goes_on(movement_.rest() - milliseconds(1)));
    EXPECT_FALSE(movement_.goes_on(movement_.rest()));
}

TEST_F(MovementTest, goes_on_however_long_the_picture_under_way_takes) {
    const auto under_way = start_ - frame;
    move(start_);
    movement_.pictured(under_way, false, start_ + slow_picture);
    stand(start_ + slow_picture, true);
    EXPECT_TRUE(movement_.goes_on(start_ + slow_picture)) << "its own picture is still to be drawn, and coarse";
    EXPECT_EQ(movement_.rest(), Movement::Time::max()) << "nothing becomes due before that";
    movement_.pictured(start_ + slow_picture, false, start_ + slow_picture + frame);
    EXPECT_FALSE(movement_.goes_on(start_ + slow_picture + frame));
}

TEST_F(MovementTest, rests_a_while_after_a_coarse_picture) {
    move(start_);
    const auto shown = start_ + slow_picture;
    movement_.pictured(start_, true, shown);
    EXPECT_EQ(movement_.rest(), shown + Movement::time_to_rest);
    movement_.pictured(shown, true, shown + slow_picture);
    EXPECT_EQ(movement_.rest(), shown + Movement::time_to_rest) << "the next ones do not prolong it";
}

TEST_F(MovementTest, awaits_no_picture_where_what_is_dragged_stands_still) {
    move(start_);
    movement_.seen(start_ + frame);
    movement_.requested(start_ + frame, false);
    EXPECT_FALSE(movement_.goes_on(start_ + frame + Movement::time_to_rest)) << "of a picture that never comes";
    move(start_);
    stand(start_ + frame, false);
    EXPECT_TRUE(movement_.goes_on(start_ + slow_picture)) << "a later frame that requests nothing new ends nothing";
}

TEST_F(MovementTest, can_be_ended) {
    move(start_);
    movement_.end();
    EXPECT_FALSE(movement_.goes_on(start_));
    EXPECT_LE(movement_.rest(), start_);
}

}  // namespace
}  // namespace steplab::ui
