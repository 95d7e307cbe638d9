#include "session/pace.hpp"

#include "support/extreme_doubles.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>

namespace steplab {
namespace {

using std::chrono::milliseconds;

constexpr Pace::Duration slice{0.008};
constexpr Rate real_time{false, 1};

/// A clock that only goes on when told to.
const Pace::Time start{};
Pace::Time at(int ms) { return start + milliseconds(ms); }

/// A pace that knows a machine of a million steps a second.
Pace measured() {
    Pace pace;
    pace.begin(start - milliseconds(10));
    pace.took(10000, 40000, 0, start - milliseconds(10), start, {true, 1});
    pace.begin(start);
    return pace;
}

TEST(Pace, takes_as_many_whole_steps_as_time_has_passed) {
    Pace pace = measured();
    EXPECT_EQ(pace.steps_due(at(99), real_time, 0.1, slice), 0u);
    EXPECT_EQ(pace.steps_due(at(100), real_time, 0.1, slice), 1u);
    EXPECT_EQ(pace.steps_due(at(300), real_time, 0.1, slice), 3u) << "although 0.3 / 0.1 is rounded below 3";
    EXPECT_EQ(pace.steps_due(at(350), real_time, 0.1, slice), 3u);
    EXPECT_EQ(pace.steps_due(at(100), {false, 5}, 0.1, slice), 5u);
}

TEST(Pace, owes_what_is_left_over_to_the_next_step) {
    Pace pace = measured();
    pace.took(1, 4, 0.1, at(150), at(150), real_time);
    EXPECT_EQ(pace.steps_due(at(199), real_time, 0.1, slice), 0u);
    EXPECT_EQ(pace.steps_due(at(200), real_time, 0.1, slice), 1u);
    EXPECT_EQ(pace.next_due(at(150), real_time, 0.1), at(200));
    EXPECT_EQ(pace.next_due(at(300), real_time, 0.1), at(300));
}

TEST(Pace, as_fast_as_possible_fills_the_slice) {
    EXPECT_EQ(measured().steps_due(start, {true, 1}, 0.1, slice), 8000u);
    EXPECT_EQ(Pace().steps_due(start, {true, 1}, 0.1, slice), 1u) << "one step to measure with";
}

TEST(Pace, does_not_take_more_at_a_time_than_fits_the_slice) {
    EXPECT_EQ(measured().steps_due(at(1000), {false, 1e9}, 0.1, slice), 8000u);
}

TEST(Pace, forgives_what_a_slow_machine_is_behind) {
    Pace pace = measured();
    pace.took(1, 4, 0.1, at(0), at(10000), real_time);  // one step took ten seconds
    EXPECT_LE(pace.steps_due(at(10000), real_time, 0.1, Pace::Duration(1e9)), 1u);
}

TEST(Pace, measures_steps_and_evaluations) {
    const Pace pace = measured();
    EXPECT_NEAR(pace.steps_per_second(), 1e6, 1);
    EXPECT_NEAR(pace.evaluations_per_second(), 4e6, 1);
    Pace forgetful = measured();
    forgetful.forget_speed();
    EXPECT_EQ(forgetful.steps_per_second(), 0);
}

TEST(Pace, has_whole_steps_and_times_for_every_speed_and_dt) {
    for (const auto& [a, b] : extreme_pairs(2000)) {
        if (!(a > 0) || !std::isfinite(b)) continue;
        const Rate rate{false, a};
        Pace pace = measured();
        Pace::Time now = start;
        for (int i = 0; i < 3; ++i) {
            EXPECT_LE(pace.steps_due(now, rate, b, slice), 1'000'000'000'000'000u) << a << ' ' << b;
            EXPECT_LE(pace.next_due(now, rate, b), now + std::chrono::hours(60'000)) << a << ' ' << b;
            pace.took(1, 1, b, now, now, rate);
            now += milliseconds(10);
        }
    }
}

TEST(Pace, a_step_of_days_is_followed_by_a_pause_and_no_rush) {
    Pace pace = measured();
    pace.took(1, 4, 1e300, at(0), at(0), real_time);
    EXPECT_GT(pace.next_due(at(10), real_time, 1e300), at(10) + std::chrono::hours(24));
    EXPECT_EQ(pace.steps_due(at(10), real_time, 0.1, slice), 0u);
}

}  // namespace
}  // namespace steplab
