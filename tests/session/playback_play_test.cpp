#include "session/playback_test.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <vector>

namespace steplab::test {
namespace {

TEST(Playback, plays_backwards_to_the_first_frame) {
    const Written written(played_chain());  // frames at 0, 0.2, 0.4 ... 4.6
    Playback playback(written.path);
    go_to(playback, 9);
    playback.handle(event::Play{true, true});
    EXPECT_TRUE(view_of(playback).line.backwards);
    playback.play_to(1.7);
    EXPECT_EQ(playback.number(), 9u) << "the one before is at 1.6";
    playback.play_to(1.6);
    EXPECT_EQ(playback.number(), 8u);
    playback.play_to(0.7);
    EXPECT_EQ(playback.number(), 4u) << "the first one that is no earlier";
    playback.play_next();
    EXPECT_EQ(playback.number(), 3u);
    EXPECT_EQ(playback.frame().positions, written.frames[3].positions);
    playback.play_to(-1);
    EXPECT_EQ(playback.number(), 0u);
    EXPECT_FALSE(playback.playing());
    playback.handle(event::Play{true, true});
    EXPECT_EQ(playback.number(), 23u) << "from the start it begins with the last one";
}

TEST(Playback, plays_a_loop_from_either_end_to_the_other) {
    const Written written(played_chain());
    for (const bool backwards : {false, true}) {
        Playback playback(written.path);
        go_to(playback, 6);
        playback.handle(event::Loop{StepRange{10, 16}});  // frames 5 to 8
        playback.handle(event::Play{true, backwards});
        const std::vector<std::uint64_t> right =
            backwards ? std::vector<std::uint64_t>{5, 8, 7, 6, 5, 8} : std::vector<std::uint64_t>{7, 8, 5, 6, 7, 8};
        for (const std::uint64_t frame : right) {
            playback.play_next();
            EXPECT_EQ(playback.number(), frame);
            EXPECT_TRUE(playback.playing());
        }
        playback.handle(event::Loop{});
        while (playback.playing()) playback.play_next();
        EXPECT_EQ(playback.number(), backwards ? 0u : 23u);
    }
}

TEST(Playback, plays_in_simulated_time_and_stops_at_the_last_frame) {
    const Written written(played_chain());
    Playback playback(written.path);
    playback.play_to(1);
    EXPECT_EQ(playback.number(), 0u) << "it does not play";
    playback.handle(event::Play{true});
    EXPECT_DOUBLE_EQ(playback.next_elapsed(), 0.2);
    playback.play_to(0.1999);
    EXPECT_EQ(playback.number(), 0u);
    playback.play_to(0.2);
    EXPECT_EQ(playback.number(), 1u);
    playback.play_to(1.1);
    EXPECT_EQ(playback.number(), 5u);
    playback.play_next();
    EXPECT_EQ(playback.number(), 6u);
    playback.play_to(1e9);
    EXPECT_EQ(playback.number(), 23u);
    EXPECT_FALSE(playback.playing());
    playback.handle(event::Play{true});
    EXPECT_EQ(playback.number(), 0u) << "from the last frame it plays from the first one";
    EXPECT_TRUE(playback.playing());
}

TEST(Playback, waits_at_the_ends_of_a_loop_as_long_as_at_any_frame) {
    for (const double dt : {0.1, -0.1}) {
        const Written written(played_chain(dt));
        Playback playback(written.path);
        go_to(playback, 23);
        EXPECT_DOUBLE_EQ(playback.next_elapsed(), 4.6) << "behind the last frame comes none";
        playback.handle(event::Loop{StepRange{0, 46}});
        EXPECT_DOUBLE_EQ(playback.next_elapsed(), 4.8);
        playback.handle(event::Play{true, true});
        while (playback.number() > 0) playback.play_next();
        EXPECT_DOUBLE_EQ(playback.next_elapsed(), -0.2);
    }
}

TEST(Playback, goes_to_a_frame_whose_time_is_given_in_ten_digits) {
    const Written written(played_chain());
    Playback playback(written.path);
    playback.handle(event::SeekTime{0.6 - 1e-10});
    EXPECT_EQ(playback.number(), 3u);
    playback.handle(event::SeekTime{0.6 - 1e-6});
    EXPECT_EQ(playback.number(), 2u);
}

}  // namespace
}  // namespace steplab::test
