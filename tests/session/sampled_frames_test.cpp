// Which frames of a file plots show.
#include "session/sampled_frames.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <vector>

namespace steplab::test {
namespace {

using Numbers = std::vector<std::uint64_t>;

Numbers all_of(SampledFrames& frames, std::uint64_t end) {
    Numbers all;
    while (const auto number = frames.next(end)) all.push_back(*number);
    return all;
}

Numbers multiples(std::uint64_t spacing, std::uint64_t end) {
    Numbers all;
    for (std::uint64_t number = 0; number < end; number += spacing) all.push_back(number);
    return all;
}

TEST(SampledFrames, are_all_of_a_short_file_and_each_once) {
    for (std::uint64_t count = 0; count < 700; ++count) {
        SampledFrames frames(10);
        EXPECT_FALSE(frames.adapt(count));
        Numbers all = all_of(frames, count);
        std::sort(all.begin(), all.end());
        ASSERT_EQ(all, multiples(1, count)) << count;
    }
}

TEST(SampledFrames, are_spread_over_the_file_at_first) {
    SampledFrames frames(10);
    frames.adapt(4000);
    Numbers first;
    while (first.size() < 60) first.push_back(*frames.next(4000));
    EXPECT_TRUE(std::is_sorted(first.begin(), first.end()));
    EXPECT_GT(first.back(), 3700u);
    EXPECT_EQ(first[1], first[2] - first[1]);
}

TEST(SampledFrames, of_a_long_file_are_evenly_spaced_and_not_too_many) {
    for (const std::uint64_t rows : {1u, 100u, 10'000u, 1'000'000u}) {
        for (const std::uint64_t count : {4096u, 4097u, 100'000u, 3'000'000u}) {
            SampledFrames frames(rows);
            frames.adapt(count);
            Numbers all = all_of(frames, count);
            std::sort(all.begin(), all.end());
            EXPECT_LE(all.size(), SampledFrames::most_frames);
            EXPECT_LE(all.size() * rows, SampledFrames::most_rows);
            EXPECT_GE(all.size(), 5u);
            EXPECT_EQ(all, multiples(all[1], count));
            EXPECT_TRUE(std::all_of(all.begin(), all.end(), [&](auto number) { return frames.has(number); }));
            EXPECT_EQ(frames.has(1), all[1] == 1);
        }
    }
}

TEST(SampledFrames, of_huge_frames_are_those_that_are_shown) {
    SampledFrames frames(2'000'000);
    EXPECT_FALSE(frames.adapt(100));
    EXPECT_FALSE(frames.next(100));
    EXPECT_TRUE(frames.has(7));
}

TEST(SampledFrames, of_a_file_that_grows_are_the_new_ones_unless_there_are_too_many) {
    SampledFrames frames(10);
    frames.adapt(100);
    EXPECT_EQ(all_of(frames, 100).size(), 100u);
    EXPECT_FALSE(frames.adapt(103));
    EXPECT_EQ(all_of(frames, 103), (Numbers{100, 101, 102}));
    EXPECT_TRUE(frames.adapt(5000)) << "every second one from now on";
    EXPECT_EQ(all_of(frames, 5000).size(), 2500u);
    EXPECT_EQ(all_of(frames, 5001), (Numbers{5000}));
}

TEST(SampledFrames, are_given_again_when_they_are_to_tell_of_other_particles) {
    SampledFrames frames(10);
    frames.adapt(5);
    all_of(frames, 5);
    frames.restart();
    EXPECT_EQ(all_of(frames, 5), multiples(1, 5));
}

}  // namespace
}  // namespace steplab::test
