#include "core/expression.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

namespace steplab {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

double value(std::string_view text) { return Expression(text)({}); }

TEST(Expression, binds_as_written_formulas_do) {
    const std::vector<std::pair<const char*, double>> cases{
        {"1 + 2 * 3", 7}, {"(1 + 2) * 3", 9}, {"2 - 3 - 4", -5}, {"12 / 3 / 2", 2},
        {"-2^2", -4},     {"(-2)^2", 4},      {"2^3^2", 512},    {"2^-1", 0.5},
        {"2 * -3", -6},   {"--2", 2},         {"-2^-2", -0.25},  {"1e3", 1000},
        {".5", 0.5},      {" 1\t+ 1 ", 2},    {"(-3)^3", -27},   {"min(2, 1) + max(2, 1)", 3},
        {"abs(-2)", 2},   {"sqrt(16)", 4},    {"0^0", 1}};
    for (const auto& [text, right] : cases) EXPECT_EQ(value(text), right) << text;
}

TEST(Expression, knows_functions_and_pi) {
    for (const double x : {-1.25, 0.5, 3.0}) {
        const double all[] = {x};
        const auto at = [&](const char* text) { return Expression(text)(all); };
        const double ulps = 4e-16 * (1 + std::exp(std::abs(x)));
        EXPECT_NEAR(at("exp(x)"), std::exp(x), ulps);
        EXPECT_NEAR(at("log(exp(x))"), x, ulps);
        EXPECT_NEAR(at("sin(x)^2 + cos(x)^2"), 1, ulps);
        EXPECT_NEAR(at("sin(x) / cos(x) - tan(x)"), 0, 10 * ulps);
        EXPECT_NEAR(at("tanh(x)"), std::tanh(x), ulps);
        EXPECT_NEAR(at("2^x"), std::pow(2, x), 8 * ulps);
    }
    EXPECT_EQ(value("pi"), std::numbers::pi);
}

TEST(Expression, takes_names_in_their_order) {
    const Expression expression("2 * k / (m_1 * k)");
    EXPECT_THAT(expression.names(), ElementsAre("k", "m_1"));
    const double values[] = {5, 4};
    EXPECT_EQ(expression(values), 0.5);
}

TEST(Expression, that_is_none_is_refused_where_it_goes_wrong) {
    const std::vector<std::pair<std::string, std::pair<std::size_t, const char*>>> cases{
        {"", {0, "ends where"}},
        {"1 +", {3, "ends where"}},
        {"(1", {2, "expected ')'"}},
        {"2 k", {2, "an operator"}},
        {"2k", {1, "an operator"}},
        {"1e999", {0, "no number"}},
        {"sinn(1)", {0, "did you mean 'sin'?"}},
        {"min(1)", {5, "expected ','"}},
        {"1)", {1, "an operator"}},
        {"a $ b", {2, "an operator"}},
        {"\x1b[2J", {0, "\\x1b[2J"}}};
    for (const auto& [text, right] : cases) {
        try {
            const Expression expression(text);
            ADD_FAILURE() << text << " is read";
        } catch (const ExpressionError& error) {
            EXPECT_EQ(error.place(), right.first) << text << ": " << error.what();
            EXPECT_THAT(error.what(), HasSubstr(right.second)) << text;
        }
    }
}

TEST(Expression, of_any_depth_ends_without_a_crash) {
    EXPECT_EQ(value(std::string(190, '(') + "1" + std::string(190, ')')), 1);
    for (const char* const deep : {"(", "-", "exp(", "2^"}) {
        std::string text;
        for (int i = 0; i < 100'000; ++i) text += deep;
        EXPECT_THROW(Expression(text + "1"), ExpressionError) << deep;
    }
}

}  // namespace
}  // namespace steplab
