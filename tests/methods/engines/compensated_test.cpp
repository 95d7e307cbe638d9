#include "methods/engines/compensated.hpp"

#include "core/phi.hpp"
#include "support/runs.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace steplab::test {
namespace {

TEST(CompensatedSum, keeps_what_rounding_cuts_off) {
    float sum = 1, lost = 0, plain = 1;
    for (int i = 0; i < 1000000; ++i) {
        add_compensated(sum, lost, 1e-8f);  // below half an ulp of 1: a plain sum never moves
        plain += 1e-8f;
    }
    EXPECT_EQ(plain, 1);
    EXPECT_NEAR(sum, 1.01, 1e-7);
}

// Of the sum as of the increment, whichever is smaller: taking the increment for the smaller one loses the sum.
TEST(CompensatedSum, keeps_what_a_large_increment_cuts_off_a_small_sum) {
    float sum = 1e-9f, lost = 0;
    add_compensated(sum, lost, 1.0f);
    EXPECT_EQ(sum, 1);
    EXPECT_EQ(lost, 1e-9f);
    const float added = 1.0f - 1e-9f;  // the partner: what is left so of the increment alone
    EXPECT_EQ(1.0f - added, 0);
}

/// By how much a sum in two parts is off after 10^5 increments a third as large as itself.
template <class Add>
double error_of_sum(Add add) {
    double sum = 0, lost = 0;
    long double wanted = 0;
    for (int i = 0; i < 100000; ++i) {
        const double increment = 0.3 * std::cos(0.3 * i);
        add(sum, lost, increment);
        wanted += increment;
    }
    return static_cast<double>(std::abs(wanted - sum - lost));
}

// What is off is the long double's own rounding, in the mean of 10^5 times 3e-20. The partner adds what was lost to the
// increment (Kahan), which rounds it to the increment's digits.
TEST(CompensatedSum, keeps_what_was_lost_from_increments_of_its_own_size) {
    EXPECT_LT(error_of_sum([](double& sum, double& lost, double more) { add_compensated(sum, lost, more); }), 5e-17);
    const auto by_kahan = [](double& sum, double& lost, double increment) {
        const double corrected = increment + lost, next = sum + corrected;
        lost = corrected - (next - sum);
        sum = next;
    };
    EXPECT_GT(error_of_sum(by_kahan), 5e-16);
}

/// Largest distance of the oscillator in float from itself in double, looked at 5 times in 2 10^5 steps of 1/4096.
double float_error(const MethodCase& c, bool compensated) {
    RunDescription description = run_of("oscillator", c.id(), Precision::float_, 1.0 / 4096);
    description.method_parameters.set("compensated", compensated ? 1 : 0);
    Simulation in_float(description);
    description.precision = Precision::double_;
    Simulation in_double(description);
    double largest = 0;
    for (int look = 0; look < 5; ++look) {
        in_float.advance(40000);
        in_double.advance(40000);
        largest = std::max(largest, distance(in_float.frame(), in_double.frame()));
    }
    return largest;
}

/// In float; stable on the oscillator.
bool has_compensated_sums_in_float(const MethodCase& c) {
    return c.precision == Precision::float_ && c.info->linear_limit != 0 &&
           ParameterValues(c.info->parameters).contains("compensated");
}

class CompensatedSumsOf : public testing::TestWithParam<MethodCase> {};

// Plain sums of small steps lose half an ulp each, 2 10^5 times; compensated ones only what the coefficients of the
// method in float are off by, at most 2e-7 of the path, which is 49.
TEST_P(CompensatedSumsOf, each_method_bring_float_closer_to_double) {
    const double plain = float_error(GetParam(), false), compensated = float_error(GetParam(), true);
    EXPECT_LT(compensated, std::max(plain / 3, 98e-7));
}

INSTANTIATE_TEST_SUITE_P(Catalogue, CompensatedSumsOf,
                         testing::ValuesIn(working_methods_where(has_compensated_sums_in_float)), case_name);

// Float stagnates where a step's way is below half an ulp of the position; compensated, it goes on.
TEST(CompensatedSum, moves_where_a_plain_sum_stands_still) {
    RunDescription description = run_of("free", "velocity-verlet", Precision::float_, 1e-5, {{"n", 3}});
    for (const double compensated : {0.0, 1.0}) {
        description.method_parameters.set("compensated", compensated);
        Simulation simulation(description);
        simulation.advance(200000);
        const double right = -0.05 * 2 * 4, y = simulation.frame().positions[2].y;
        if (compensated != 0) {
            EXPECT_NEAR(y, right, 1e-5);
        } else {
            EXPECT_GT(std::abs(y - right), 1e-5);
        }
    }
}

TEST(Phi1, is_that_of_its_definition_in_every_precision) {
    for (const long double z : {-40.0L, -3.0L, -0.51L, -0.49L, -1e-3L, -1e-9L, 0.0L, 1e-9L, 0.3L, 0.5L, 0.7L, 20.0L}) {
        const long double right = z == 0 ? 1 : std::expm1(z) / z;
        EXPECT_NEAR(static_cast<double>(phi_1(z) / right), 1, 1e-18);
        EXPECT_NEAR(phi_1(static_cast<double>(z)) / static_cast<double>(right), 1, 1e-15);  // two roundings of e^z - 1
        EXPECT_NEAR(phi_1(static_cast<float>(z)) / static_cast<float>(right), 1, 2e-7);
    }
}

}  // namespace
}  // namespace steplab::test
