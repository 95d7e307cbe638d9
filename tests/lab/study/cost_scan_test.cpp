#include "lab/study/cost_scan.hpp"

#include "lab/study/quick_reference.hpp"
#include "lab/study/study.hpp"
#include "sim/catalogue.hpp"
#include "sim/run/simulation.hpp"
#include "support/runs.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <set>
#include <span>
#include <string>
#include <vector>

namespace steplab::test {
namespace {

std::vector<CostPoint> all_points(CostScan& scan, std::size_t most = 1000) {
    std::vector<CostPoint> points;
    while (points.size() < most) {
        const auto point = scan.next();
        if (!point) break;
        put(points, *point);
    }
    return points;
}

RunDescription oscillator() { return run_of("oscillator", "rk4", Precision::double_, 0.1); }

TEST(CostScan, has_points_of_every_method_that_takes_the_scene_in_both_precisions) {
    CostScan scan(oscillator());
    std::set<std::pair<std::string, Precision>> seen;
    for (const CostPoint& point : all_points(scan)) seen.insert({point.run.method, point.run.precision});
    for (const Method& method : methods()) {
        if (method.info.curiosity) continue;
        EXPECT_TRUE(seen.contains({std::string(method.info.id), Precision::double_})) << method.info.id;
        EXPECT_TRUE(seen.contains({std::string(method.info.id), Precision::float_})) << method.info.id;
    }
    EXPECT_EQ(scan.done(), 1);
    EXPECT_FALSE(scan.next()) << "it stays at its end";
    EXPECT_EQ(scan.how(), "exact solution");
}

// Each method comes before any comes a second time: there is something to compare at once.
TEST(CostScan, begins_with_all_methods) {
    CostScan scan(oscillator());
    const auto points = all_points(scan, 30);
    std::set<std::string> methods_seen;
    for (const CostPoint& point : points) methods_seen.insert(point.run.method);
    EXPECT_GE(methods_seen.size(), 10u) << "of the first thirty points";
}

// What a point says is what the run does.
TEST(CostScan, points_are_what_their_runs_do) {
    CostScan scan(oscillator());
    for (const CostPoint& point : all_points(scan, 60)) {
        SCOPED_TRACE(command_line(point.run));
        Simulation simulation(point.run);
        simulation.end_at(run_end(point.run, scan.time()));
        simulation.advance(run_end(point.run, scan.time()).step);
        EXPECT_EQ(static_cast<double>(simulation.evaluations()), point.evaluations);
        const auto error = simulation.diagnostics().error;
        ASSERT_TRUE(error);
        // no smaller than the error of the reference, here rounding of double; in float dt is rounded, and with it the
        // end by 1e-6 s
        EXPECT_NEAR(*error, point.error,
                    1e-6 * point.error + (point.run.precision == Precision::float_ ? 1e-6 : 1e-14));
    }
}

// A report has a better reference where that is a run; both say no less than the errors of theirs.
TEST(CostScan, points_have_the_errors_that_a_report_has) {
    for (const char* const model : {"oscillator", "chain", "morse"}) {
        const RunDescription scene = describe(model);
        CostScan scan(scene);
        const StudyPlan plan = plan_for(scene, scan.time(), false);
        const Reference reference = reference_for(plan);
        int compared = 0;
        for (const CostPoint& point : all_points(scan, 60)) {
            ASSERT_FALSE(point.provisional) << "each came once more";
            SCOPED_TRACE(command_line(point.run));
            const std::uint64_t steps = run_end(point.run, scan.time()).step;
            const Measurement reported = measure(point.run, steps, reference);
            EXPECT_EQ(static_cast<double>(reported.result.evaluations), point.evaluations);
            if (reference.exact) {
                EXPECT_EQ(reported.error, point.error);
            } else {
                EXPECT_NEAR(reported.error, point.error, 0.05 * point.error) << "5 %: as little as a plot shows";
            }
            ++compared;
        }
        EXPECT_EQ(compared, 60) << model;
    }
}

// The partner: a method of higher order gains more from half of the step.
TEST(CostScan, errors_fall_as_the_orders_of_methods_say) {
    CostScan scan(oscillator(), std::nullopt, infinity);  // a slow machine has the same points
    std::map<std::string, std::vector<CostPoint>> by_method;
    const std::vector<CostPoint>& slowest = by_method["euler-forward"];
    while (slowest.empty() || slowest.back().error > 4e-4) {
        const auto point = scan.next();
        ASSERT_TRUE(point);
        if (point->run.precision == Precision::double_ && !chooses_its_steps(point->run))
            by_method[point->run.method].push_back(*point);
    }
    for (const auto& [method, order] :
         std::map<std::string, double>{{"euler-forward", 1}, {"rk4", 4}, {"velocity-verlet", 2}}) {
        const auto& points = by_method.at(method);
        std::size_t judged = 0;
        for (std::size_t i = 1; i < points.size(); ++i) {
            // where errors are neither saturated nor rounding, nor the next order is in them
            if (points[i - 1].error > (order == 1 ? 1e-2 : 1e-3) || points[i].error < 1e-10) continue;
            EXPECT_NEAR(std::log2(points[i - 1].error / points[i].error), order, 0.25) << method << " " << i;
            ++judged;
        }
        EXPECT_GE(judged, 3u) << method;
    }
}

TEST(CostScan, methods_of_own_steps_go_through_tolerances) {
    CostScan scan(oscillator());
    double expected = 1e-2;
    std::size_t seen = 0;
    for (const CostPoint& point : all_points(scan)) {
        if (point.run.method != "dop853" || point.run.precision != Precision::double_) continue;
        EXPECT_DOUBLE_EQ(point.run.method_parameters["tolerance"], expected);
        expected /= 10;
        ++seen;
    }
    EXPECT_GE(seen, 8u);
}

TEST(CostScan, tells_what_a_run_of_ones_own_costs) {
    CostScan scan(oscillator());
    RunDescription run = oscillator();
    run.dt = 0.05;
    const auto point = scan.cost_of(run);
    ASSERT_TRUE(point);
    EXPECT_EQ(point->run, run);
    EXPECT_EQ(point->evaluations, 4 * std::ceil(scan.time() / 0.05));
    RunDescription beyond = run_of("oscillator", "euler-forward", Precision::float_, 100);
    EXPECT_TRUE(scan.cost_of(beyond)) << "its dt is shortened to the time of the scan";
}

// There is something to see at once, and nothing of it stays where the reference is better.
TEST(CostScan, first_points_are_against_a_quick_reference_and_come_once_more) {
    CostScan scan(describe("morse"));
    EXPECT_FALSE(scan.provisional()) << "nothing is known";
    std::vector<CostPoint> first, once_more;
    auto point = scan.next();
    for (; point && point->provisional; point = scan.next()) {
        EXPECT_TRUE(scan.provisional());
        EXPECT_EQ(scan.done(), 0);
        first.push_back(*point);
    }
    const std::string how = scan.how();
    ASSERT_TRUE(point);
    ASSERT_GE(first.size(), 20u);
    for (; once_more.size() < first.size(); point = scan.next()) once_more.push_back(point.value());
    EXPECT_NE(how.find("long double"), std::string::npos) << how;
    for (std::size_t i = 0; i < first.size(); ++i) {
        EXPECT_EQ(first[i].run, once_more[i].run);
        EXPECT_FALSE(once_more[i].provisional);
        EXPECT_NEAR(first[i].error, once_more[i].error, 1e-3 * once_more[i].error + 1e-9)
            << "the quick reference is better than coarse runs";
    }
}

TEST(CostScan, of_a_closed_form_is_never_provisional) {
    CostScan scan(oscillator());
    for (const CostPoint& point : all_points(scan, 60)) EXPECT_FALSE(point.provisional);
}

// A cut-off keeps long double's order 16 from being any use; the quick reference is better there.
TEST(CostScan, of_forces_with_a_kink_has_the_better_reference) {
    RunDescription scene = describe("crystal");
    const double time = CostScan::time_for(scene);
    const auto quick = quick_reference(scene, time, 1e8);
    ASSERT_TRUE(quick);
    const Reference slow = reference(scene, std::span(&time, 1), {.most_refinements = 1});
    EXPECT_LT(quick->moments.back().error, slow.moments.back().error / 10);
}

TEST(CostScan, a_point_takes_the_place_of_a_provisional_one_of_the_same_run) {
    std::vector<CostPoint> points;
    put(points, {.run = oscillator(), .error = 1, .provisional = true});
    put(points, {.run = with_method(oscillator(), "euler"), .error = 2});
    put(points, {.run = oscillator(), .error = 3});
    ASSERT_EQ(points.size(), 2u);
    EXPECT_EQ(points[0].error, 3);
    put(points, {.run = oscillator(), .error = 4});
    EXPECT_EQ(points.size(), 3u) << "what is not provisional stays";
}

// Implicit methods of many pairs take long for their first run: it is put off, and made at the end.
TEST(CostScan, of_slow_methods_has_points_too) {
    CostScan scan(describe("crystal"), 2.0);
    std::set<std::string> seen;
    for (const CostPoint& point : all_points(scan, 100000)) seen.insert(point.run.method);
    for (const char* const method : {"implicit-midpoint", "tr-bdf2", "velocity-verlet", "rk4"})
        EXPECT_TRUE(seen.contains(method)) << method;
    EXPECT_EQ(scan.done(), 1);
}

// Every first run is put off, and then given up.
TEST(CostScan, ends_where_every_run_takes_too_long) {
    CostScan scan(oscillator(), std::nullopt, 0);
    EXPECT_FALSE(scan.next());
    EXPECT_EQ(scan.done(), 1);
}

TEST(CostScan, of_every_model_has_points) {
    for (const Model& model : models()) {
        CostScan scan(describe(model.info.id, "rk4"));
        EXPECT_EQ(all_points(scan, 5).size(), 5u) << model.info.id;
    }
}

}  // namespace
}  // namespace steplab::test
