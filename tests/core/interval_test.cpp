#include "core/interval.hpp"

#include "core/expression.hpp"
#include "core/expression_graph.hpp"

#include <gtest/gtest.h>

#include <random>
#include <string>
#include <vector>

namespace steplab::test {
namespace {

ExpressionProgram program_of(const std::string& text) {
    ExpressionGraph graph;
    const ExpressionGraph::Place x = graph.variable(0);
    const Expression expression(text);
    const std::vector<ExpressionGraph::Place> names(expression.names().size(), x);
    const ExpressionGraph::Place result = graph.add(expression, names);
    return graph.program(std::vector{result}, 1);
}

template <class N>
N value_of(const ExpressionProgram& program, N x) {
    std::vector<N> slots(program.slots, N(0.0));
    slots[0] = x;
    program.set_constants<double>(std::span<N>(slots));
    program.run(std::span<N>(slots));
    return slots[program.results[0]];
}

const std::vector<std::string> expressions{"x + 2*x^3",        "exp(-x^2)",       "exp(-x^2/0.01)*x", "1/x",
                                           "log(x)",           "sqrt(x + 3)",     "sin(3*x)*x",       "cos(x)^2",
                                           "tan(x)",           "tanh(5*x - 2)",   "abs(x) - 1",       "max(x, 1 - x)",
                                           "1/(1 + exp(9*x))", "(x + 4)^0.7 - x", "min(x^2, 3)^x"};

// Whatever the range, no value in it lies outside but for rounding.
TEST(Intervals, of_expressions_hold_all_their_values) {
    std::mt19937_64 random(1);
    const auto number = [&](double width) { return std::uniform_real_distribution<double>(-width, width)(random); };
    for (const std::string& text : expressions) {
        const ExpressionProgram program = program_of(text);
        for (int i = 0; i < 300; ++i) {
            const double middle = number(4), half = std::exp(number(4) - 3);
            const Interval all = value_of(program, Interval(middle - half, middle + half));
            for (int k = 0; k <= 40; ++k) {
                const double value = value_of(program, middle + half * (k / 20.0 - 1));
                if (!std::isfinite(value)) continue;
                const double rounding = 1e-13 * (1 + std::abs(value));
                EXPECT_GE(value, all.low - rounding) << text << " around " << middle << ", half width " << half;
                EXPECT_LE(value, all.high + rounding) << text << " around " << middle << ", half width " << half;
            }
        }
    }
}

// Else nothing would be told by them.
TEST(Intervals, of_expressions_are_as_narrow_as_their_ranges_get) {
    for (const std::string& text : expressions) {
        const ExpressionProgram program = program_of(text);
        const Interval all = value_of(program, Interval(0.7, 0.7 + 1e-6));
        EXPECT_LT(all.high - all.low, 1e-3) << text;
        EXPECT_TRUE(all.has(value_of(program, 0.7 + 5e-7))) << text;
    }
}

TEST(Intervals, of_what_has_no_value_are_unbounded) {
    for (const char* text : {"1/x", "log(x)", "x/x^3", "tan(2*x)"}) {
        const Interval all = value_of(program_of(text), Interval(-1, 1));
        EXPECT_EQ(all.largest(), std::numeric_limits<double>::infinity()) << text;
    }
}

}  // namespace
}  // namespace steplab::test
