#include "ui/coarseness.hpp"

#include <gtest/gtest.h>

namespace steplab::ui {
namespace {

constexpr double fast = 0.5 * Coarseness::enough, slow = 2 * Coarseness::enough, very_slow = 20 * Coarseness::enough;
constexpr bool moves = true, stands = false;

TEST(coarseness, the_first_picture_is_drawn_in_full) {
    EXPECT_EQ(Coarseness{}.next(moves), 1);
    EXPECT_EQ(Coarseness{}.next(stands), 1);
}

TEST(coarseness, fast_pictures_are_drawn_in_full_while_the_camera_moves) {
    Coarseness coarseness;
    coarseness.took(1, fast);
    EXPECT_EQ(coarseness.next(moves), 1);
    coarseness.took(1, 1.01 * Coarseness::enough);
    EXPECT_EQ(coarseness.next(moves), 2) << "a little too slow is too slow";
}

TEST(coarseness, slow_pictures_are_coarse_only_while_the_camera_moves) {
    Coarseness coarseness;
    coarseness.took(1, slow);
    EXPECT_EQ(coarseness.next(moves), 2);
    EXPECT_EQ(coarseness.next(stands), 1);
    coarseness.took(2, fast);
    EXPECT_EQ(coarseness.next(moves), 2) << "not back to what is known to be slow";
}

TEST(coarseness, it_is_never_coarser_than_needed_or_than_the_coarsest) {
    Coarseness coarseness;
    coarseness.took(1, slow);
    coarseness.took(2, slow);
    EXPECT_EQ(coarseness.next(moves), 4);
    coarseness.took(2, fast);
    EXPECT_EQ(coarseness.next(moves), 2);
    coarseness.took(2, slow);
    coarseness.took(4, very_slow);
    EXPECT_EQ(coarseness.next(moves), Coarseness::coarsest);
}

TEST(coarseness, very_slow_pictures_are_at_once_as_coarse_as_they_have_to_be) {
    Coarseness coarseness;
    coarseness.took(1, very_slow);
    EXPECT_EQ(coarseness.next(moves), 4);
}

TEST(coarseness, another_scene_is_judged_by_its_own_pictures) {
    Coarseness coarseness;
    coarseness.took(1, very_slow);
    coarseness.took(2, very_slow);
    coarseness.took(4, very_slow);
    coarseness.took(1, slow);
    EXPECT_EQ(coarseness.next(moves), 2);
    coarseness.took(1, fast);
    EXPECT_EQ(coarseness.next(moves), 1);
    Coarseness same;
    same.took(1, slow);
    same.took(2, slow);
    same.took(1, 1.1 * slow);
    EXPECT_EQ(same.next(moves), 4) << "the same scene a little slower";
}

}  // namespace
}  // namespace steplab::ui
