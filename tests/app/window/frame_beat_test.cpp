// How many frames a window draws, and when.
#include "app/window/frame_beat.hpp"

#include <gtest/gtest.h>

namespace steplab::test {
namespace {

using std::chrono::microseconds;
using std::chrono::milliseconds;
using std::chrono::seconds;

const FrameBeat::Time start{std::chrono::hours(1)};

/// How many frames of a second look otherwise than those before, if each is drawn so much later than it is due, and is
/// in a hurry or not.
int frames_a_second(FrameBeat::Clock::duration late, bool urgent) {
    FrameBeat beat(start);
    int frames = 0;
    for (auto now = beat.due() + late; now <= start + seconds(1); now = beat.due() + late) {
        beat.draw(now);
        beat.show();
        if (urgent) beat.hurry();
        ++frames;
    }
    return frames;
}

TEST(FrameBeat, is_60_a_second_also_where_each_frame_comes_a_little_late) {
    for (const bool urgent : {false, true}) {
        for (const int late : {0, 50, 700, 3000, 8000}) {
            const int frames = frames_a_second(microseconds(late), urgent);
            EXPECT_GE(frames, 59) << late << " microseconds late";
            EXPECT_LE(frames, 60);
        }
        EXPECT_LT(frames_a_second(milliseconds(12), urgent), 40) << "more than half a frame: it is counted from there";
    }
}

TEST(FrameBeat, does_not_catch_up_after_a_rest) {
    FrameBeat beat(start);
    const auto later = start + seconds(5);
    EXPECT_EQ(beat.draw(later), later - start);
    beat.show();
    EXPECT_EQ(beat.due(), later + FrameBeat::frame_time);
}

TEST(FrameBeat, lets_what_waits_go_before_frames_that_look_as_before) {
    FrameBeat beat(start);
    const auto now = start + FrameBeat::frame_time;
    beat.draw(now);
    EXPECT_EQ(beat.due(), now + FrameBeat::frame_time);
    beat.hurry();
    EXPECT_EQ(beat.due(), now + FrameBeat::frame_time / 4) << "it looked as before";
    beat.show();
    EXPECT_EQ(beat.due(), now + FrameBeat::frame_time) << "it did not";
}

TEST(FrameBeat, is_not_early_after_a_frame_that_was_drawn_before_it_was_due) {
    FrameBeat beat(start);
    const auto early = start + milliseconds(3);
    beat.draw(early);
    EXPECT_EQ(beat.due(), early + FrameBeat::frame_time);
}

}  // namespace
}  // namespace steplab::test
