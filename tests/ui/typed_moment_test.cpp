#include "ui/typed_moment.hpp"

#include "core/error.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

namespace steplab::ui {
namespace {

TEST(typed_moment, is_a_time_or_a_step) {
    EXPECT_EQ(std::get<event::SeekTime>(typed_moment("12.5")).time, 12.5);
    EXPECT_EQ(std::get<event::Seek>(typed_moment("step 120")).step, 120u);
}

TEST(typed_moment, refuses_others_with_both_that_would_be_right) {
    for (const char* const wrong : {"nonsense", "-1", "12 s", "step"}) {
        try {
            typed_moment(wrong);
            ADD_FAILURE() << wrong;
        } catch (const UsageError& error) {
            EXPECT_THAT(error.what(), testing::AllOf(testing::HasSubstr("t must be a number >= 0"),
                                                     testing::HasSubstr("\"step 120\"")));
        }
    }
    EXPECT_THROW(typed_moment("step one"), UsageError);
}

}  // namespace
}  // namespace steplab::ui
