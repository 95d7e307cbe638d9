#include "core/error.hpp"
#include "lab/advice.hpp"
#include "lab/answers.hpp"
#include "lab/report_page.hpp"
#include "lab/study.hpp"
#include "sim/catalogue.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace steplab::test {
namespace {

using testing::HasSubstr;
using testing::Not;

StudyPlan small_plan(std::vector<std::string> methods) {
    StudyPlan plan{.scene = describe("chain", "rk4"),
                   .time = 5,
                   .methods = std::move(methods),
                   .method_settings = {},
                   .precisions = {Precision::double_}};
    plan.most_seconds_a_run = 0.002;
    plan.rounds = 1;
    return plan;
}

const auto no_progress = [](double) {};

TEST(SpeedError, falls_with_dt_by_the_order_of_the_method) {
    const StudyPlan plan = small_plan({"verlet", "pefrl"});
    const auto runs = measure_series(plan, reference_for(plan), no_progress);
    for (const char* method : {"verlet", "pefrl"}) {
        EXPECT_NEAR(measured_order(runs, method, Precision::double_).value_or(0), steplab::method(method).info.order,
                    0.3)
            << method;
    }
    for (const Measurement& run : runs)
        EXPECT_GT(run.wall_seconds.value_or(0), 0) << run.run.method << " " << run.run.dt;
}

TEST(SpeedError, ends_where_the_run_was_asked_to_end) {
    const StudyPlan plan = small_plan({"rk4"});
    for (const Measurement& run : measure_series(plan, reference_for(plan), no_progress))
        EXPECT_NEAR(run.run.dt * static_cast<double>(run.steps), plan.time, 1e-12);
}

// 9^3 + 1 particles of which every pair acts on each other: too many for the linear solver of tr-bdf2.
TEST(SpeedError, leaves_out_methods_that_refuse_the_scene) {
    StudyPlan plan = small_plan({"verlet", "tr-bdf2"});
    EXPECT_EQ(possible_methods(plan), plan.methods);
    plan.scene = describe("morse", "verlet");
    plan.scene.scene.set("edge", 9);
    EXPECT_EQ(possible_methods(plan), std::vector<std::string>{"verlet"});
}

// A wrong scene has an error that no dt takes away: the partner of the orders above.
TEST(SpeedError, of_a_wrong_scene_does_not_fall) {
    const StudyPlan right = small_plan({"pefrl"});
    StudyPlan wrong = right;
    wrong.scene.scene.set("k", 1.01);
    const auto runs = measure_series(wrong, reference_for(right), no_progress);
    const auto least =
        std::min_element(runs.begin(), runs.end(), [](const auto& a, const auto& b) { return a.error < b.error; });
    EXPECT_GT(least->error, 1e-3);
}

TEST(SpeedError, is_never_below_that_of_the_reference) {
    const StudyPlan plan = small_plan({"pefrl"});
    Reference reference = reference_for(plan);
    reference.moments.back().error = 1e-5;
    for (const Measurement& run : measure_series(plan, reference, no_progress)) EXPECT_GE(run.error, 1e-5);
}

TEST(Advice, keeps_the_error_it_was_asked_for) {
    const StudyPlan plan = small_plan({"euler", "rk4", "pefrl"});
    const Reference reference = reference_for(plan);
    for (const double error : {1e-2, 1e-5, 1e-9}) {
        const Advice advice = advise(plan, error, reference, no_progress);
        EXPECT_LE(measure(advice.best.run, advice.best.steps, reference).error, error);
        EXPECT_FALSE(advice.best.diverged);
    }
}

TEST(Advice, takes_no_smaller_dt_than_needed) {
    const StudyPlan plan = small_plan({"pefrl"});
    const Reference reference = reference_for(plan);
    const Advice advice = advise(plan, 1e-6, reference, no_progress);
    const auto fewer = static_cast<std::uint64_t>(0.9 * static_cast<double>(advice.best.steps));
    EXPECT_GT(measure(run_over(plan, "pefrl", Precision::double_, fewer), fewer, reference).error, 1e-6);
}

TEST(Advice, says_what_can_be_had_where_the_error_cannot) {
    const StudyPlan plan = small_plan({"pefrl"});
    try {
        advise(plan, 1e-18, reference_for(plan), no_progress);
        FAIL() << "an error below rounding was promised";
    } catch (const UsageError& refusal) {
        EXPECT_THAT(refusal.what(), HasSubstr("1e-18"));
    }
}

TEST(ReportPage, holds_every_method_and_needs_nothing_else) {
    const StudyPlan plan = small_plan({"euler", "rk4", "pefrl"});
    Study study{plan, reference_for(plan), {}};
    study.runs = measure_series(plan, study.reference, no_progress);
    const std::string page = report_page(std::vector{study}, std::vector{1e-2, 1e-6}, circumstances());
    for (const char* word : {"<svg", "euler", "rk4", "pefrl", "error ≤ 1e-02", "Reference: ", "</html>"})
        EXPECT_THAT(page, HasSubstr(word));
    for (const char* word : {"src=", "<link", "@import", "url("}) EXPECT_THAT(page, Not(HasSubstr(word)));
    EXPECT_EQ(std::count(page.begin(), page.end(), '\0'), 0);
}

}  // namespace
}  // namespace steplab::test
