#include "core/pair_approach.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace steplab::test {
namespace {

constexpr double never = std::numeric_limits<double>::infinity();

/// An attraction of 1 / r^2.
const ApproachTable& gravity() {
    static const ApproachTable table([](double r) { return -1 / (r * r); }, 0);
    return table;
}
/// Two lengths of 0.1 m within a cut-off at 1.5 m.
const ApproachTable& narrow() {
    static const ApproachTable table([](double r) { return std::exp(-(r - 0.5) / 0.1); }, 1.5);
    return table;
}

ApproachTable::Pair head_on(double distance, double speed) {
    return {.distance = distance, .speed2 = speed * speed, .momentum2 = 0, .strength = 1, .negligible = 0};
}

/// The distance of two bodies that fall towards each other, after a time: by steps of a leapfrog so small that their
/// error does not count.
double distance_after(double time, double distance, double radial, double sideways) {
    double x = distance, y = 0, u = -radial, v = sideways;
    constexpr int steps = 20000;
    const double h = time / steps;
    for (int i = 0; i < steps; ++i) {
        x += u * h / 2, y += v * h / 2;
        const double r = std::hypot(x, y), pull = -h / (r * r * r);
        u += pull * x, v += pull * y;
        x += u * h / 2, y += v * h / 2;
    }
    return std::hypot(x, y);
}

// The force of gravity matters as 1 / r: four times as much at a quarter of the distance.
TEST(ApproachTable, tells_no_time_after_the_force_has_grown) {
    std::mt19937_64 random(1);
    std::uniform_real_distribution<double> number(0, 1);
    int told = 0;
    for (int i = 0; i < 300; ++i) {
        const double distance = std::exp(4 * number(random) - 2), radial = 3 * number(random),
                     sideways = 0.4 * number(random);
        ApproachTable::Pair pair = head_on(distance, std::hypot(radial, sideways));
        pair.momentum2 = distance * distance * sideways * sideways;
        const double time = gravity().time_to_growth(pair, 1e9);
        if (time == never) continue;
        ++told;
        // a table's step is 3 % of the distance
        EXPECT_GT(distance_after(time, distance, radial, sideways), distance / 4 * 0.96) << distance;
        EXPECT_LT(distance_after(time, distance, radial, sideways), distance) << "no step is free";
    }
    EXPECT_GT(told, 100);
}

TEST(ApproachTable, leaves_alone_what_does_not_come_near) {
    ApproachTable::Pair circle = head_on(1, 1);
    circle.momentum2 = 1;
    EXPECT_EQ(gravity().time_to_growth(circle, 1e9), never);
    circle.momentum2 = 0;
    EXPECT_LT(gravity().time_to_growth(circle, 1e9), never);
    EXPECT_EQ(gravity().time_to_growth(circle, 0.1), never) << "in so short a step it does not get there";
}

TEST(ApproachTable, lets_particles_come_as_far_as_a_cutoff_and_a_step_of_the_table_beyond) {
    ApproachTable::Pair pair = head_on(10, 2);
    pair.negligible = 1e-9;
    const double time = narrow().time_to_growth(pair, 1e9);
    EXPECT_LE(time, (8.5 + 1.5 / 32) / 2);
    EXPECT_GE(time, 8.5 / 2);
}

TEST(ApproachTable, overlooks_what_is_negligible) {
    ApproachTable::Pair pair = head_on(1.45, 1);
    const double at_once = narrow().time_to_growth(pair, 1e9);
    pair.negligible = 1e-2;  // |F'| r^2 = 0.01 where exp(-10 (r - 0.5)) is 1e-3 / r^2
    const double later = narrow().time_to_growth(pair, 1e9);
    EXPECT_LT(at_once, 0.2);
    EXPECT_GT(later, at_once + 0.1);
}

TEST(ApproachTable, knows_the_length_of_a_force) {
    EXPECT_NEAR(narrow().length(1, 1e-9), 0.1, 0.03);  // r^2 falls while the force grows
    EXPECT_GT(gravity().length(1, 1e-9), 1e6);
    EXPECT_NEAR(gravity().least_way(), 0.74, 0.02);
    EXPECT_LT(narrow().least_way(), 0.1);
    EXPECT_EQ(narrow().cutoff(), 1.5);
    EXPECT_NEAR(narrow().outermost(1, 1e-6), 1.5, 0.05);
    EXPECT_EQ(narrow().outermost(1, 1e300), 0);
}

}  // namespace
}  // namespace steplab::test
