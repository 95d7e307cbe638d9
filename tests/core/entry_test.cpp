#include "core/entry.hpp"

#include "core/error.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

namespace steplab {
namespace {

constexpr std::string_view places[] = {"centre", "corner"};
constexpr ParameterInfo infos[] = {
    {.name = "n", .kind = ParameterInfo::Kind::integer, .minimum = 2, .default_value = 10},
    {.name = "m", .minimum = 0, .minimum_included = false, .default_value = 1},
    {.name = "L", .minimum = 0, .default_value = 2},
    {.name = "v0", .minimum = -infinity, .default_value = 1},
    {.name = "kick", .kind = ParameterInfo::Kind::choice, .default_value = 0, .choices = places},
    {.name = "fixed", .kind = ParameterInfo::Kind::integer, .minimum = 0, .maximum = 1, .default_value = 1}};

/// The message with which setting `name` to `text` is refused; empty if it is not.
std::string refusal(std::string_view name, std::string_view text) {
    ParameterValues values(infos);
    try {
        values.set_text(name, text);
    } catch (const UsageError& error) {
        EXPECT_EQ(error.code(), ExitCode::usage);
        return error.what();
    }
    return "";
}

TEST(Entry, values_start_at_their_defaults) {
    const ParameterValues values(infos);
    for (const auto& info : infos) EXPECT_EQ(values[info.name], info.default_value) << info.name;
}

TEST(Entry, a_refusal_names_parameter_text_and_range) {
    EXPECT_EQ(refusal("n", "1"), "n must be an integer >= 2 (got \"1\")");
    EXPECT_EQ(refusal("m", "0"), "m must be a number > 0 (got \"0\")");
    EXPECT_EQ(refusal("L", "-1"), "L must be a number >= 0 (got \"-1\")");
    EXPECT_EQ(refusal("kick", "side"), "kick must be centre or corner (got \"side\")");
    EXPECT_EQ(refusal("fixed", "2"), "fixed must be 0 or 1 (got \"2\")");
    EXPECT_EQ(refusal("v0", "fast"), "v0 must be a finite number (got \"fast\")");
}

TEST(Entry, ranges_are_written_without_exponents_and_with_their_ends) {
    using Kind = ParameterInfo::Kind;
    EXPECT_EQ(range_text({.name = "substeps", .kind = Kind::integer, .minimum = 1, .maximum = 1e6}),
              "an integer from 1 to 1000000");
    EXPECT_EQ(range_text({.name = "part", .minimum = 0, .maximum = 0.5}), "a number from 0 to 0.5");
    EXPECT_EQ(range_text({.name = "part", .minimum = 0, .minimum_included = false, .maximum = 0.5}),
              "a number > 0 and <= 0.5");
    EXPECT_EQ(range_text({.name = "shift", .kind = Kind::integer, .minimum = -infinity}), "an integer");
}

TEST(Entry, text_that_is_not_a_number_of_the_kind_is_refused) {
    for (const char* text : {"", "nan", "inf", "-inf", "2.5", "1e300", "ten", "10 "})
        EXPECT_NE(refusal("n", text), "") << text;
    for (const char* text : {"nan", "inf", "1e999", "1.0x"}) EXPECT_NE(refusal("v0", text), "") << text;
}

TEST(Entry, the_edges_of_a_range_are_allowed) {
    EXPECT_EQ(refusal("n", "2"), "");
    EXPECT_EQ(refusal("m", "1e-300"), "");
    EXPECT_EQ(refusal("L", "0"), "");
    EXPECT_EQ(refusal("v0", "-1e308"), "");
    EXPECT_EQ(refusal("fixed", "0"), "");
}

TEST(Entry, a_refused_value_leaves_the_old_one) {
    ParameterValues values(infos);
    EXPECT_THROW(values.set("m", -1), UsageError);
    EXPECT_EQ(values["m"], 1);
}

TEST(Entry, values_are_compared_by_content_not_by_the_place_of_their_descriptions) {
    constexpr ParameterInfo count{.name = "n", .kind = ParameterInfo::Kind::integer, .default_value = 3};
    constexpr ParameterInfo mass{.name = "m", .default_value = 3};
    const ParameterInfo one[] = {count}, same[] = {count}, other_name[] = {mass}, longer[] = {count, mass};
    const ParameterValues values(one);
    EXPECT_EQ(values, ParameterValues(same));
    EXPECT_NE(values, ParameterValues(other_name));
    EXPECT_NE(values, ParameterValues(longer));
    EXPECT_NE(values, ParameterValues());
    ParameterValues changed(same);
    changed.set("n", 4);
    EXPECT_NE(values, changed);
}

TEST(Entry, an_equal_index_of_another_choice_is_another_value) {
    constexpr std::string_view sides[] = {"left", "right"};
    const ParameterInfo place[] = {{.name = "at", .kind = ParameterInfo::Kind::choice, .choices = places}};
    const ParameterInfo side[] = {{.name = "at", .kind = ParameterInfo::Kind::choice, .choices = sides}};
    EXPECT_EQ(ParameterValues(place), ParameterValues(place));
    EXPECT_NE(ParameterValues(place), ParameterValues(side));
}

TEST(Entry, choices_are_written_as_their_words) {
    ParameterValues values(infos);
    values.set_text("kick", "corner");
    EXPECT_EQ(values["kick"], 1);
    EXPECT_EQ(format_value(infos[4], values["kick"]), "corner");
    EXPECT_THROW(values.set("kick", 2), UsageError);
}

TEST(Entry, substeps_multiply_cost_and_limit) {
    static constexpr ParameterInfo substeps[] = {
        {.name = "substeps", .kind = ParameterInfo::Kind::integer, .default_value = 10}};
    const MethodInfo info{.evaluations = 1, .linear_limit = 2, .parameters = substeps};
    EXPECT_EQ(evaluations_per_step(info, ParameterValues(substeps)), 10);
    EXPECT_EQ(linear_limit(info, ParameterValues(substeps)), 20);
    EXPECT_EQ(linear_limit(info, ParameterValues()), 2);
}

}  // namespace
}  // namespace steplab
