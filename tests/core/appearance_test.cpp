#include "core/appearance.hpp"

#include "core/error.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

namespace steplab {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

std::string refusal(const std::string& view) {
    try {
        parse_view(view, "camera");
        return "read";
    } catch (const UsageError& error) {
        return error.what();
    }
}

TEST(Appearance, views_are_words_or_six_numbers) {
    for (const char* word : {"default", "front", "side", "top"}) EXPECT_EQ(parse_view(word, "camera").word, word);
    const WrittenView view = parse_view("30,-12.5,4,1,2e-3,-3", "camera");
    EXPECT_TRUE(view.word.empty());
    EXPECT_EQ(view.yaw, 30);
    EXPECT_EQ(view.pitch, -12.5);
    EXPECT_EQ(view.distance, 4);
    EXPECT_EQ(view.focus.x, 1);
    EXPECT_EQ(view.focus.y, 2e-3);
    EXPECT_EQ(view.focus.z, -3);
}

TEST(Appearance, other_views_are_refused_by_the_name_of_their_key) {
    for (const char* view : {"", "Top", "1,2,3", "1,2,3,4,5,6,7", "1,2,x,4,5,6", "1,91,3,4,5,6", "1,2,0,4,5,6",
                             "1,2,-3,4,5,6", "nan,2,3,4,5,6", "1,2,3,4,5,", "1 ,2,3,4,5,6"}) {
        EXPECT_THAT(refusal(view), StartsWith("camera must be default, front, side, top or yaw")) << view;
    }
    EXPECT_THAT(refusal("1,2,1e-100,4,5,6"), StartsWith("camera: the distance must be from 1e-99 to 1e102"));
    EXPECT_THAT(refusal("1,2,3,4,5,1e103"), HasSubstr("(got 1,2,3,4,5,1e103)"));
}

TEST(Appearance, words_are_those_of_the_lists) {
    for (const std::string_view word : colouring_ids) EXPECT_EQ(id(colouring_of(word)), word);
    for (const std::string_view word : background_ids) EXPECT_EQ(id(background_of(word)), word);
    EXPECT_THROW(colouring_of("sped"), UsageError);
    EXPECT_THROW(background_of(""), UsageError);
}

}  // namespace
}  // namespace steplab
