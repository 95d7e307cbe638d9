#include "core/error.hpp"
#include "core/number_text.hpp"
#include "core/text.hpp"
#include "lab/studies.hpp"
#include "lab/study/advice.hpp"
#include "lab/study/answers.hpp"
#include "lab/study/gain_watch.hpp"
#include "sim/catalogue.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace steplab::test {
namespace {

using testing::HasSubstr;

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

// verlet would gain from smaller steps for much longer; a series ended by the number of steps is not cut by time.
TEST(SpeedError, takes_no_run_of_more_steps_than_the_plan_allows) {
    StudyPlan plan = small_plan({"verlet"});
    plan.most_steps_a_run = 100;
    SeriesState state;
    continue_series(
        plan, reference_for(plan), state, [] {}, no_progress);
    const auto most = std::max_element(state.runs.begin(), state.runs.end(),
                                       [](const auto& a, const auto& b) { return a.steps < b.steps; });
    ASSERT_NE(most, state.runs.end());
    EXPECT_LE(most->steps, 100u);
    EXPECT_GT(most->steps, 50u);  // the next one, of twice as many, is the first that is not allowed
    EXPECT_TRUE(state.cut.empty());
}

TEST(SpeedError, ends_at_the_requested_time) {
    const StudyPlan plan = small_plan({"rk4"});
    for (const Measurement& run : measure_series(plan, reference_for(plan), no_progress))
        EXPECT_NEAR(run.run.dt * static_cast<double>(run.steps), plan.time, 1e-12);
}

// 9^3 + 1 particles of which every pair acts on each other: too many for the linear solver of tr-bdf2.
TEST(SpeedError, leaves_out_methods_that_cannot_run_the_scene) {
    StudyPlan plan = small_plan({"verlet", "tr-bdf2"});
    EXPECT_EQ(possible_methods(plan), plan.methods);
    plan.scene = describe("morse", "verlet");
    plan.scene.scene.set("edge", 9);
    EXPECT_EQ(possible_methods(plan), std::vector<std::string>{"verlet"});
}

// The partner of the orders above: a wrong scene has an error that no dt reduces.
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

// gauss-16 shortens a dt that is too large for it, so that its first runs are all the same: they do not end the series.
TEST(SpeedError, continues_past_runs_that_cost_no_more_than_the_previous_one) {
    StudyPlan plan = small_plan({"gauss-16"});
    plan.time = 60;
    const auto runs = measure_series(plan, reference_for(plan), no_progress);
    const auto by_dt = std::count_if(runs.begin(), runs.end(), [](const auto& m) { return !chooses_its_steps(m.run); });
    const auto exact = std::count_if(runs.begin(), runs.end(),
                                     [](const auto& m) { return !chooses_its_steps(m.run) && m.error < 1e-13; });
    EXPECT_GE(exact, 1);
    EXPECT_GT(static_cast<std::ptrdiff_t>(runs.size()), by_dt);  // and some by tolerance
}

/// All measured values of a run except its time.
std::string found(const Measurement& m) {
    return fmt::format("{} {} {} {} {} {} {} {}", m.run.method, id(m.run.precision), m.steps, m.result.evaluations,
                       m.error, m.rms_error, m.result.energy_error, m.result.hash);
}

// No series is ended by time, so that the runs do not depend on the clock.
TEST(SpeedError, of_series_measured_in_parallel_is_that_of_each_alone_in_the_order_of_the_plan) {
    StudyPlan plan = small_plan({"kahan-li-8", "gauss-16", "rkn-12-10", "dop853"});
    plan.precisions = {Precision::float_, Precision::double_};
    const Reference reference = reference_for(plan);
    std::vector<std::string> together, alone;
    SeriesState state;
    const auto save = [&] {
        for (std::size_t i = together.size(); i < state.runs.size(); ++i) together.push_back(found(state.runs[i]));
    };
    continue_series(plan, reference, state, save, no_progress);
    EXPECT_EQ(state.series, 8u);
    for (const std::string& method : plan.methods) {
        for (const Precision precision : plan.precisions) {
            StudyPlan one = plan;
            one.methods = {method};
            one.precisions = {precision};
            for (const Measurement& run : measure_series(one, reference, no_progress)) alone.push_back(found(run));
        }
    }
    EXPECT_EQ(together, alone);
}

// Series that were complete at an interruption, after one that was not.
TEST(SpeedError, continues_around_series_that_are_complete) {
    const StudyPlan plan = small_plan({"pefrl", "rk4", "kahan-li-8"});
    SeriesState state;
    state.ahead[1] = {{run_with("rk4", 0.1, 123, 1e-6)}, true};
    state.timed = true;
    continue_series(
        plan, reference_for(plan), state, [] {}, no_progress);
    EXPECT_EQ(state.series, 3u);
    EXPECT_TRUE(state.ahead.empty());
    std::vector<std::string> methods;
    for (const Measurement& run : state.runs) {
        if (methods.empty() || methods.back() != run.run.method) methods.push_back(run.run.method);
        EXPECT_EQ(run.error == 123, run.run.method == "rk4");
    }
    EXPECT_EQ(methods, plan.methods);
    EXPECT_TRUE(
        std::any_of(state.cut.begin(), state.cut.end(), [](const CutSeries& it) { return it.method == "rk4"; }));
}

/// The series that are cut by time if no run may take longer than this.
std::vector<CutSeries> cut_by(double most_seconds_a_run) {
    StudyPlan plan = small_plan({"pefrl", "gauss-16"});
    plan.most_seconds_a_run = most_seconds_a_run;
    SeriesState state;
    continue_series(
        plan, reference_for(plan), state, [] {}, no_progress);
    return state.cut;
}

// A run takes more than a nanosecond, and 1/10000 of a minute.
TEST(SpeedError, names_the_series_that_time_ends_and_no_other) {
    const auto cut = cut_by(1e-9);
    ASSERT_EQ(cut.size(), 2u);
    EXPECT_EQ(cut[0].method, "pefrl");
    EXPECT_EQ(cut[1].method, "gauss-16");
    EXPECT_EQ(cut_by(60).size(), 0u);
}

TEST(GainWatch, ends_after_two_that_cost_more_and_are_no_better) {
    const auto costing = [](std::uint64_t evaluations, double error) {
        Measurement m = run_with("rk4", 0.1, error, 1e-6);
        m.result.evaluations = evaluations;
        return m;
    };
    GainWatch more_expensive, equally_expensive;
    EXPECT_FALSE(more_expensive.gains_no_more(costing(100, 1e-9)));
    EXPECT_FALSE(more_expensive.gains_no_more(costing(200, 1e-9)));
    EXPECT_TRUE(more_expensive.gains_no_more(costing(400, 1e-9)));
    for (int run = 0; run < 5; ++run) EXPECT_FALSE(equally_expensive.gains_no_more(costing(100, 1e-9)));
}

TEST(Advice, keeps_the_requested_error) {
    const StudyPlan plan = small_plan({"euler", "rk4", "pefrl"});
    const Reference reference = reference_for(plan);
    for (const double error : {1e-2, 1e-5, 1e-9}) {
        const Advice advice = advise(plan, error, reference, no_progress);
        EXPECT_LE(measure(advice.best.run, advice.best.steps, reference).error, error);
        EXPECT_FALSE(advice.best.diverged());
    }
}

TEST(Advice, uses_no_smaller_dt_than_needed) {
    const StudyPlan plan = small_plan({"pefrl"});
    const Reference reference = reference_for(plan);
    const Advice advice = advise(plan, 1e-6, reference, no_progress);
    const auto fewer = static_cast<std::uint64_t>(0.9 * static_cast<double>(advice.best.steps));
    EXPECT_GT(measure(run_over(plan, "pefrl", Precision::double_, fewer), fewer, reference).error, 1e-6);
}

TEST(Advice, compares_with_rk4_however_slow_that_is) {
    const StudyPlan plan = small_plan({"rk4", "taylor"});
    const Advice advice = advise(plan, 1e-11, reference_for(plan), no_progress);
    EXPECT_EQ(advice.best.run.method, "taylor");
    ASSERT_EQ(advice.others.size(), 1u);
    EXPECT_EQ(advice.others[0].run.method, "rk4");
}

TEST(Advice, uses_tolerances_that_can_be_typed) {
    const StudyPlan plan = small_plan({"taylor"});
    const Advice advice = advise(plan, 1e-9, reference_for(plan), no_progress);
    const double tolerance = advice.best.run.method_parameters["tolerance"];
    EXPECT_EQ(parse_number(typed(tolerance, 1)), tolerance);
}

TEST(Advice, names_the_smallest_error_where_the_requested_one_is_not_reached) {
    const StudyPlan plan = small_plan({"pefrl"});
    try {
        advise(plan, 1e-18, reference_for(plan), no_progress);
        FAIL() << "an error below rounding was promised";
    } catch (const UsageError& refusal) {
        EXPECT_THAT(refusal.what(), HasSubstr("1e-18"));
    }
}

}  // namespace
}  // namespace steplab::test
