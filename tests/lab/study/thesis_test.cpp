#include "lab/study/thesis.hpp"

#include "sim/run/simulation.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>

namespace steplab::test {
namespace {

/// Verlet's three points on absolute positions, as the thesis writes them, for the chain of table 1: L = 3, k = m = 1,
/// the first particle fixed, the last one kicked with 1. No special case for equal positions, no increments.
template <class T>
T plain_three_points(int steps) {
    constexpr std::size_t n = 10;
    const T dt = static_cast<T>(0.1), rest = 3;
    std::array<T, n> x{}, before{}, a{};
    for (std::size_t i = 0; i < n; ++i) x[i] = before[i] = rest * static_cast<T>(i);
    before[n - 1] -= dt;  // moved with v0 = 1
    for (int step = 0; step < steps; ++step) {
        a.fill(0);
        for (std::size_t i = 0; i + 1 < n; ++i) {
            const T d = x[i + 1] - x[i], pull = (std::abs(d) - rest) / std::abs(d) * d;
            a[i] += pull;
            a[i + 1] -= pull;
        }
        for (std::size_t i = 1; i < n; ++i) {
            const T next = 2 * x[i] - before[i] + dt * dt * a[i];
            before[i] = x[i];
            x[i] = next;
        }
    }
    return x[n - 1];
}

// The thesis printed 25.7907 for Verlet: rounding in float of differences of positions near 26.
TEST(ThesisTable1, has_verlets_digits_from_absolute_positions_in_float) {
    EXPECT_EQ(fmt::format("{:.4f}", plain_three_points<float>(681)), "25.7907");
    EXPECT_EQ(fmt::format("{:.4f}", plain_three_points<double>(681)), "25.7906");  // the partner: without rounding
}

std::string stoermer_in_float(double substeps) {
    RunDescription run = describe("chain", "stoermer");
    run.precision = Precision::float_;
    run.scene.set("L", 3);
    run.scene.set("v0", 1);
    run.method_parameters.set("substeps", substeps);
    Simulation simulation(run);
    simulation.advance(681);
    return fmt::format("{:.4f}", simulation.frame().positions[9].x);
}

// It printed 25.7906 for Störmer: one substep gives this value, no other number up to twenty does.
TEST(ThesisTable1, has_stoermers_digits_from_a_single_substep) {
    EXPECT_EQ(stoermer_in_float(1), "25.7906");
    for (int substeps = 2; substeps <= 20; ++substeps) EXPECT_NE(stoermer_in_float(substeps), "25.7906") << substeps;
}

TEST(ThesisTable1, has_a_row_for_each_of_the_five_methods) {
    const Table table = thesis_table_1();
    ASSERT_EQ(table.rows.size(), 5u);
    for (const auto& row : table.rows) EXPECT_EQ(row.size(), table.head.size());
}

TEST(ThesisCharts, show_every_method_and_precision_with_the_exact_motion) {
    const auto charts = thesis_charts();
    std::size_t of_the_chain = 0;
    for (const ThesisChart& chart : charts) {
        if (chart.title.find("tenth particle") == std::string::npos) continue;
        ++of_the_chain;
        EXPECT_EQ(chart.figure.curves.size(), 6u) << chart.title;
        EXPECT_EQ(chart.figure.curves.back().name, "exact");
    }
    EXPECT_EQ(of_the_chain, 6u);  // dt = 0.1, 0.5 and 0.9, each in double and in float
}

}  // namespace
}  // namespace steplab::test
