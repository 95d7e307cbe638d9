#include "lab/study/answers.hpp"

#include "core/error.hpp"
#include "lab/studies.hpp"
#include "lab/study/speed_error_csv.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace steplab::test {
namespace {

using testing::HasSubstr;

TEST(Answers, take_the_fastest_that_keeps_the_error) {
    const std::vector<Measurement> runs{run_with("rk4", 0.1, 1e-5, 3e-6), run_with("pefrl", 0.2, 1e-5, 1e-6),
                                        run_with("euler", 0.1, 1e-2, 1e-7)};
    EXPECT_EQ(fastest(runs, 1e-4), &runs[1]);
    EXPECT_EQ(fastest(runs, 1e-4, "rk4"), &runs[0]);
    EXPECT_EQ(fastest(runs, 1e-7), nullptr);
    EXPECT_EQ(answer(runs, 1e-4), "pefrl at dt 0.2 in double, 3 times faster than rk4");
    EXPECT_EQ(answer(runs, 1e-7), "no run reached this error");
}

TEST(Answers, never_take_a_failed_run_for_a_fast_one) {
    const std::vector<Measurement> runs{diverged("euler", 1e-9), run_with("rk4", 0.1, 1e-5, 3e-6)};
    EXPECT_EQ(fastest(runs, 1), &runs[1]);
    EXPECT_EQ(pareto_front(runs).size(), 1u);
}

TEST(Answers, of_the_front_are_optimal) {
    const std::vector<Measurement> runs{run_with("rk4", 0.1, 1e-5, 3e-6), run_with("pefrl", 0.2, 1e-6, 1e-6),
                                        run_with("euler", 0.1, 1e-2, 1e-7), run_with("verlet", 0.1, 1e-2, 2e-7)};
    const auto front = pareto_front(runs);
    ASSERT_EQ(front.size(), 2u);
    EXPECT_EQ(front[0], &runs[2]);
    EXPECT_EQ(front[1], &runs[1]);
}

TEST(MeasuredOrder, is_the_slope_away_from_the_largest_and_smallest_errors) {
    std::vector<Measurement> runs;
    for (double dt = 1; dt > 1e-3; dt /= 2) runs.push_back(run_with("rk4", dt, std::pow(dt, 4) + 1e-11, 1e-6));
    EXPECT_NEAR(*measured_order(runs, "rk4", Precision::double_), 4, 0.05);
    EXPECT_FALSE(measured_order(runs, "rk4", Precision::float_));
    EXPECT_FALSE(measured_order(runs, "euler", Precision::double_));
}

// Errors that grow where dt shrinks are rounding, not an order.
TEST(MeasuredOrder, is_none_where_errors_do_not_fall) {
    const std::vector<Measurement> runs{run_with("rk4", 1, 1e-14, 1e-6), run_with("rk4", 0.5, 1e-9, 1e-6),
                                        run_with("rk4", 0.25, 2e-6, 1e-6), run_with("rk4", 0.125, 1e-4, 1e-6)};
    EXPECT_FALSE(measured_order(runs, "rk4", Precision::double_));
}

TEST(SpeedErrorCsv, reads_back_exactly) {
    std::vector<Measurement> runs{run_with("rk4", 0.1, 1.0 / 3, 1e-6), run_with("stoermer", 0.1, 1e-300, 1e-6),
                                  diverged("euler", 1)};
    runs[0].run.precision = Precision::float_;
    runs[0].run.scene.set("n", 17);
    runs[1].run.method_parameters.set("substeps", 3);
    runs[2].wall_seconds.reset();
    const std::vector<Measurement> back = parse_speed_error_csv(speed_error_csv(runs), describe("chain"));
    ASSERT_EQ(back.size(), runs.size());
    for (std::size_t i = 0; i < runs.size(); ++i) {
        EXPECT_EQ(back[i].run, runs[i].run);
        EXPECT_EQ(back[i].steps, runs[i].steps);
        EXPECT_EQ(back[i].wall_seconds, runs[i].wall_seconds);
        EXPECT_EQ(back[i].diverged(), runs[i].diverged());
        EXPECT_EQ(back[i].error, runs[i].diverged() ? 0 : runs[i].error);
    }
}

TEST(SpeedErrorCsv, has_the_columns_of_the_contract_and_empty_cells_for_a_failed_run) {
    const std::string csv = speed_error_csv(std::vector{diverged("euler", 1)});
    EXPECT_THAT(
        csv, testing::StartsWith("model,method,precision,dt,steps,evaluations,wall_s,error,energy_error,status,hash"));
    EXPECT_THAT(csv, HasSubstr(",,,diverged,"));
}

TEST(SpeedErrorCsv, refuses_other_text) {
    EXPECT_THROW(parse_speed_error_csv("chain,rk4,double\n", describe("chain")), Error);
    EXPECT_THROW(parse_speed_error_csv("chain,rk4,double,x,1,1,,,,ok,0,,,\n", describe("chain")), Error);
    EXPECT_THROW(parse_speed_error_csv("chain,nonsense,double,1,1,1,,,,ok,0,,,\n", describe("chain")), Error);
    EXPECT_THROW(parse_speed_error_csv("chain,rk4,quad,1,1,1,,,,ok,0,,,\n", describe("chain")), Error);
}

}  // namespace
}  // namespace steplab::test
