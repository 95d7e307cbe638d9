#include "core/expression_graph.hpp"

#include "core/elementary_numbers.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace steplab::test {
namespace {

using Place = ExpressionGraph::Place;

/// An expression in x and y as a graph, and the programs of what is made of it.
struct Graph {
    explicit Graph(const std::string& text) : expression(text) {
        for (const std::string& name : expression.names()) names.push_back(graph.variable(name == "y" ? 1 : 0));
        value = graph.add(expression, names);
    }

    template <class N>
    N at(Place place, const N& x, const N& y) const {
        const ExpressionProgram program = graph.program(std::array{place}, 2);
        std::vector<N> slots(program.slots, N(0.0));
        program.set_constants<double>(std::span<N>(slots));
        slots[0] = x, slots[1] = y;
        program.run(std::span<N>(slots));
        return slots[program.results[0]];
    }
    double plain(double x, double y) const {
        std::vector<double> values;
        for (const std::string& name : expression.names()) values.push_back(name == "y" ? y : x);
        return expression(values);
    }
    std::size_t steps(Place place) const { return graph.program(std::array{place}, 2).steps.size(); }

    Expression expression;
    ExpressionGraph graph;
    std::vector<Place> names;
    Place value = 0;
};

/// Every operation and function.
const std::array texts{"x + 2*y - 3",
                       "x*y/(x + y)",
                       "-x^2",
                       "x^3 - x^-2 + x^0.5 + x^1.5 - x^-1.5 + x^0.3 + x^y",
                       "x^0.25 + x^1.75 - x^-0.75 + (x*y)^-2.25",
                       "(x^2)^0.5 + (x^0.5)^2 + (x^3)^2 + (x*y)^3",
                       "exp(-x/y) + log(x + y) + sqrt(x*y)",
                       "sin(x)*cos(y) + tan(x/3) - tanh(x - y)",
                       "abs(x - y)*min(x, 2*y) + max(x, y)^2.5",
                       "max(0, 1 - x)^2 + min(0, x - 1)",
                       "4*((1/x)^12 - (1/x)^6)",
                       "((x + y)*(x - y))^4/(1 + x*x*y*y) + pi"};

// Simplified, the operations are others: a few ulp of a few terms of size 10^3.
TEST(ExpressionGraph, has_the_value_of_the_expression) {
    for (const char* const text : texts) {
        const Graph g(text);
        for (const auto& [x, y] : {std::pair(0.7, 1.3), std::pair(1.9, 0.4), std::pair(2.5, 2.25)}) {
            const double value = g.plain(x, y);
            EXPECT_NEAR(g.at(g.value, x, y), value, 2e-14 * (1 + std::abs(value))) << text;
        }
    }
}

// The derivative by dual numbers is exact to rounding.
TEST(ExpressionGraph, derivative_is_that_of_dual_numbers) {
    for (const char* const text : texts) {
        Graph g(text);
        const Place slope_x = g.graph.derivative(g.value, 0), slope_y = g.graph.derivative(g.value, 1);
        for (const auto& [x, y] : {std::pair(0.7, 1.3), std::pair(1.9, 0.4), std::pair(2.5, 2.25)}) {
            const double by_x = g.at(g.value, Dual(x, 1.0), Dual(y, 0.0)).derivative;
            const double by_y = g.at(g.value, Dual(x, 0.0), Dual(y, 1.0)).derivative;
            EXPECT_NEAR(g.at(slope_x, x, y), by_x, 1e-13 * (1 + std::abs(by_x))) << text;
            EXPECT_NEAR(g.at(slope_y, x, y), by_y, 1e-13 * (1 + std::abs(by_y))) << text;
        }
    }
}

TEST(ExpressionGraph, second_derivative_of_a_power) {
    Graph g("x^5");
    const Place second = g.graph.derivative(g.graph.derivative(g.value, 0), 0);
    EXPECT_DOUBLE_EQ(g.at(second, 2.0, 0.0), 160);
}

TEST(ExpressionGraph, lanes_have_the_bits_of_single_numbers) {
    using N = RegisterLanes<double, 64>;
    const auto x = [](std::size_t lane) { return 0.3 + 0.07 * static_cast<double>(lane); };
    for (const char* const text : texts) {
        const Graph g(text);
        const N all = g.at(g.value, N::each(x), N(1.1));
        for (std::size_t lane = 0; lane < N::count; ++lane)
            EXPECT_EQ(all[lane], g.at(g.value, x(lane), 1.1)) << text << " lane " << lane;
    }
}

TEST(ExpressionGraph, needs_no_more_operations_than_a_person_would) {
    EXPECT_EQ(Graph("x + 0*y - 0 + 1*x - x").steps(Graph("x + 0*y - 0 + 1*x - x").value), 0U);
    EXPECT_EQ(Graph("2*3*x*4").steps(Graph("2*3*x*4").value), 1U) << "numbers are multiplied beforehand";
    EXPECT_EQ(Graph("x^8").steps(Graph("x^8").value), 3U) << "by squaring";
    EXPECT_EQ(Graph("(x + y)^2 + (x + y)").steps(Graph("(x + y)^2 + (x + y)").value), 3U) << "x + y once";
    EXPECT_EQ(Graph("exp(2 - 2)").steps(Graph("exp(2 - 2)").value), 0U);
}

// sigma / r to even powers: of r^2 alone.
TEST(ExpressionGraph, even_powers_of_a_root_need_no_root) {
    for (const char* text : {"1/r^12 - 1/r^6", "exp(-(r/0.5)^2)", "(2*r*3)^4 + (r/7)^-2"}) {
        ExpressionGraph graph;
        const Place r = graph.square_root(graph.variable(0));
        const Place value = graph.add(Expression(text), std::array{r});
        for (const Place result : {value, graph.derivative(value, 0)}) {
            for (const auto& step : graph.program(std::array{result}, 1).steps)
                EXPECT_NE(step.operation, ExpressionProgram::Operation::sqrt) << text;
        }
    }
}

// A power in general takes some forty times as long.
TEST(ExpressionGraph, half_powers_of_a_root_are_made_of_roots) {
    for (const char* text : {"sqrt(r)", "r^1.5", "r^-2.5", "1/sqrt(r) - r^0.5", "r^7.5"}) {
        ExpressionGraph graph;
        const Place r = graph.square_root(graph.variable(0));
        const Place value = graph.add(Expression(text), std::array{r});
        for (const Place result : {value, graph.derivative(value, 0)}) {
            for (const auto& step : graph.program(std::array{result}, 1).steps)
                EXPECT_NE(step.operation, ExpressionProgram::Operation::power) << text;
        }
    }
}

TEST(ExpressionGraph, substitutes_a_variable) {
    Graph g("sin(x)*y + x^y");
    const Place there = g.graph.substituted(g.value, 0, g.graph.number(0.75));
    EXPECT_FALSE(g.graph.depends(there, 0));
    EXPECT_TRUE(g.graph.depends(there, 1));
    EXPECT_DOUBLE_EQ(g.at(there, 100.0, 1.5), g.plain(0.75, 1.5));
}

// A left-deep sum of thousands of terms, which a recursion would take to the end of the stack.
TEST(ExpressionGraph, takes_long_sums) {
    std::string text = "x";
    for (int k = 1; k < 1900; ++k) text += " + y^" + std::to_string(k % 900 + 1);
    Graph g(text);
    EXPECT_TRUE(g.graph.depends(g.graph.derivative(g.value, 1), 1));
    EXPECT_NEAR(g.at(g.value, 1.0, 0.5), g.plain(1.0, 0.5), 1e-11);
}

}  // namespace
}  // namespace steplab::test
