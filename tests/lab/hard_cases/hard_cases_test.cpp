#include "core/flush_subnormals.hpp"
#include "lab/hard_cases/hard_case.hpp"
#include "sim/run/segment.hpp"
#include "support/runs.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace steplab::test {
namespace {

using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

constexpr const char* fixed_steps[] = {"euler",           "midpoint",    "rk4",   "stoermer",          "verlet",
                                       "velocity-verlet", "forest-ruth", "pefrl", "mclachlan-atela-5", "srkn-11b",
                                       "kahan-li-8"};
constexpr const char* finding_collisions[] = {"dopri5", "dop853", "rkn-12-10"};

/// The table of a case, as the page shows it.
class CaseTable {
public:
    explicit CaseTable(std::string_view id) : table_(hard_case(id).table()) {
        EXPECT_EQ(table_.rows.size(), methods().size());
    }

    std::string cell(std::string_view method, std::size_t column) const {
        for (const auto& row : table_.rows) {
            if (row.front() == fmt::format("`{}`", method)) return row.at(column);
        }
        ADD_FAILURE() << method << " has no row";
        return "";
    }

    /// The number in a cell, or the bound in a cell like "< 1e-13"; infinity if there is none.
    double number(std::string_view method, std::size_t column) const {
        const std::string text = cell(method, column);
        const std::string digits = text.starts_with("< ") ? text.substr(2) : text;
        char* end = nullptr;
        const double value = std::strtod(digits.c_str(), &end);
        return end == digits.c_str() ? infinity : value;
    }

private:
    Table table_;
};

TEST(HardCase, is_found_by_its_id_only) {
    for (const HardCase& each : hard_cases()) EXPECT_EQ(hard_case(each.id).id, each.id);
    EXPECT_ANY_THROW(hard_case("easy"));
}

bool is_fit_to_draw(const plot::Plot& figure) {
    bool fit = !figure.x.name.empty() && !figure.y.name.empty() && !figure.curves.empty();
    for (const plot::Curve& curve : figure.curves)
        fit = fit && !curve.name.empty() && curve.x.size() > 1 && curve.y.size() == curve.x.size();
    return fit;
}

std::vector<std::string> ids() {
    std::vector<std::string> all;
    for (const HardCase& each : hard_cases()) all.emplace_back(each.id);
    return all;
}

class HardCaseOf : public testing::TestWithParam<std::string> {};

TEST_P(HardCaseOf, this_id_has_a_diagram_of_curves_and_labels) {
    EXPECT_TRUE(is_fit_to_draw(hard_case(GetParam()).figure()));
}

INSTANTIATE_TEST_SUITE_P(HardCases, HardCaseOf, testing::ValuesIn(ids()), [](const auto& test) {
    std::string name = test.param;
    std::replace(name.begin(), name.end(), '-', '_');
    return name;
});

TEST(HardCase, diagrams_without_curves_or_names_are_found) {
    const plot::Curve curve{.name = "rk4", .x = {0, 1}, .y = {0, 1}};
    EXPECT_TRUE(is_fit_to_draw({.x = {.name = "t"}, .y = {.name = "x"}, .curves = {curve}}));
    EXPECT_FALSE(is_fit_to_draw({.x = {.name = "t"}, .y = {}, .curves = {curve}}));
    EXPECT_FALSE(is_fit_to_draw({.x = {.name = "t"}, .y = {.name = "x"}}));
    EXPECT_FALSE(is_fit_to_draw({.x = {.name = "t"}, .y = {.name = "x"}, .curves = {{.name = "rk4", .x = {0, 1}}}}));
}

// Just below the limit the amplitude of verlet is at most 2 (8 (1 - 0.999))^(-1/2) = 22; just above it all methods
// grow, except srkn-11b, whose unstable band is narrower than that.
TEST(HardCase, marginal_dt_is_bounded_below_the_limit_and_blows_up_above) {
    const CaseTable table("marginal-dt");
    for (const char* method : fixed_steps) {
        if (linear_limit(steplab::method(method).info, ParameterValues(steplab::method(method).info.parameters)) == 0) {
            EXPECT_THAT(table.cell(method, 2), StartsWith("blows up in step")) << method;
            continue;
        }
        EXPECT_LT(table.number(method, 2), 30) << method;
        if (std::string_view(method) != "srkn-11b") {
            EXPECT_THAT(table.cell(method, 3), StartsWith("blows up in step")) << method;
        }
    }
    EXPECT_THAT(table.cell("rk4", 2), HasSubstr("decays"));
    EXPECT_THAT(table.cell("verlet", 2), Not(HasSubstr("decays")));
    for (const char* method : {"implicit-midpoint", "gauss-16", "dopri5", "taylor"})
        EXPECT_NEAR(table.number(method, 2), 1, 0.1) << method;
    EXPECT_THAT(table.cell("tr-bdf2", 2), HasSubstr("decays"));
}

// For each dt a slightly different energy is conserved; if dt changes in phase with the motion, the differences add up.
// The partners conserve no such energy, or the exact one.
TEST(HardCase, changed_dt_destroys_the_bounded_energy_error_of_symplectic_methods) {
    const CaseTable table("changed-dt");
    for (const char* method : {"stoermer", "verlet", "velocity-verlet", "forest-ruth", "pefrl", "srkn-11b"}) {
        EXPECT_LT(table.number(method, 2), 2 * table.number(method, 1)) << method;
        EXPECT_GT(table.number(method, 3), 50 * table.number(method, 1)) << method;
    }
    EXPECT_LT(table.number("rk4", 3), table.number("rk4", 1));
    EXPECT_LT(table.number("implicit-midpoint", 3), 1e-12);  // 10^4 roundings
}

TEST(HardCase, step_resonances_are_bands_with_stable_steps_above) {
    const CaseTable table("step-resonance");
    EXPECT_THAT(table.cell("srkn-11b", 1), testing::MatchesRegex("3.14[0-9]* to 3.142[0-9]*, by 4..e-04 per step; .*"));
    EXPECT_THAT(table.cell("kahan-li-8", 1), StartsWith("3.096"));
    EXPECT_EQ(table.cell("verlet", 1), "above 2");  // the partner: no band
}

// Limits of omega dt at gamma / omega = 20 and 100, to two digits, by an independent program.
TEST(HardCase, drag_lowers_the_limit_of_methods_with_backward_substeps) {
    const CaseTable table("drag");
    const auto expect = [&](const char* method, double at_20, double at_100) {
        EXPECT_NEAR(table.number(method, 4), at_20, 6e-3) << method;
        EXPECT_NEAR(table.number(method, 5), at_100, 6e-3) << method;
    };
    expect("forest-ruth", 0.92, 0.33);
    expect("pefrl", 1.36, 0.40);
    expect("mclachlan-atela-5", 1.60, 0.48);
    expect("kahan-li-8", 0.95, 0.26);
    expect("srkn-11b", 4.95, 1.67);
    EXPECT_GE(table.number("velocity-verlet", 4), 2);  // the partner: never backwards
}

void expect_collisions_to_be_passed(const CaseTable& table, std::size_t energy, std::size_t collisions) {
    for (const char* method : finding_collisions) {
        EXPECT_LT(table.number(method, energy), 1e-6) << method;
        EXPECT_GE(table.number(method, collisions), 2) << method;
    }
    for (const char* method : fixed_steps) EXPECT_GT(table.number(method, energy), 1e-5) << method;  // the partners
}

TEST(HardCase, passing_neighbours_are_found) { expect_collisions_to_be_passed(CaseTable("passing"), 1, 3); }

TEST(HardCase, colliding_cube_is_passed) { expect_collisions_to_be_passed(CaseTable("cube"), 1, 3); }

TEST(HardCase, folding_mesh_reverses_springs) {
    const CaseTable table("folding");
    for (const char* method : {"rk4", "srkn-11b", "rkn-12-10", "gauss-16", "tr-bdf2"})
        EXPECT_GE(table.number(method, 1), 2) << method;
    for (const char* method : finding_collisions) EXPECT_LT(table.number(method, 2), 1e-3) << method;
    EXPECT_GT(table.number("velocity-verlet", 2), 1e-3);
}

// With an impact parameter the force is smooth; head on it jumps.
TEST(HardCase, grazing_hits_are_as_bad_as_head_on_ones_where_steps_do_not_resolve_them) {
    const CaseTable table("grazing");
    for (const char* method : {"srkn-11b", "kahan-li-8", "gauss-16"}) {
        EXPECT_LT(table.number(method, 1), 1e-10) << method;
        EXPECT_GT(table.number(method, 4), 1e-5) << method;
        EXPECT_GT(table.number(method, 5), 1e-5) << method;
    }
    for (std::size_t column = 1; column <= 5; ++column) EXPECT_LT(table.number("rkn-12-10", column), 1e-8) << column;
}

TEST(HardCase, coincident_particles_separate_with_finite_numbers) {
    const CaseTable table("coincident");
    for (const MethodCase& c : working_methods()) {
        for (std::size_t column = 1; column <= 3; ++column) EXPECT_LT(table.number(c.id(), column), 1) << c.id();
    }
    EXPECT_LT(table.number("gauss-16", 3), 1e-12);
    EXPECT_GT(table.number("euler", 3), 1e-3);  // the partner
}

// At the threshold an energy error of 1e-5 D turns them back within 2000 time units, one of 1e-9 does not.
TEST(HardCase, escape_at_the_threshold_depends_on_the_energy) {
    const CaseTable table("escape");
    EXPECT_LT(table.number("gauss-16", 2), 1e-6);
    EXPECT_LT(table.number("srkn-11b", 2), 1e-6);
    EXPECT_THAT(table.cell("gauss-16", 1), Not(HasSubstr("turned back")));
    EXPECT_THAT(table.cell("velocity-verlet", 1), HasSubstr("turned back"));
    EXPECT_THAT(table.cell("rk4", 1), HasSubstr("turned back"));
}

TEST(HardCase, deep_repulsion_is_accurate_with_steps_that_resolve_it) {
    const CaseTable table("deep");
    for (const char* method : {"srkn-11b", "kahan-li-8", "rkn-12-10", "gauss-16"})
        EXPECT_LT(table.number(method, 2), 1e-10) << method;
    // at tolerance 1e-9 per step, with errors amplified by the collision
    for (const char* method : {"dopri5", "dop853", "rkn-12-10", "taylor", "ias15"})
        EXPECT_LT(table.number(method, 2), 1e-7) << method;
    for (const char* method : {"srkn-11b", "kahan-li-8", "pefrl", "rk4"})  // the partners: 20 times as long
        EXPECT_GT(table.number(method, 4), 1e-3) << method;
}

TEST(HardCase, stiff_rope_rests_exactly_with_implicit_and_adaptive_methods) {
    const CaseTable table("stiff-rope");
    for (const char* method : {"tr-bdf2", "dopri5", "dop853", "rkn-12-10", "taylor", "gauss-16", "ias15"}) {
        EXPECT_LT(table.number(method, 3), 2e-10) << method;
        EXPECT_LT(table.number(method, 4), 1e-8) << method;
    }
    for (const char* method : fixed_steps) {
        for (const std::size_t column : {1u, 3u, 4u}) EXPECT_THAT(table.cell(method, column), StartsWith("blows up"));
    }
    EXPECT_GT(table.number("implicit-midpoint", 1), 10 * table.number("tr-bdf2", 1));
}

// Phases over 2 10^4 steps of 0.1: verlet is ahead by t dt^2 / 24 = 0.83, rk4 behind by t dt^4 / 120 = 1.7e-3.
TEST(HardCase, long_time_phases_are_those_of_theory) {
    const CaseTable table("long-time");
    EXPECT_NEAR(table.number("verlet", 1), 0.83, 0.01);
    EXPECT_NEAR(table.number("rk4", 1), -1.7e-3, 1e-4);
    EXPECT_LT(std::abs(table.number("gauss-16", 1)), 1e-9);
    for (const char* method : fixed_steps) EXPECT_LT(std::abs(table.number(method, 3)), 1e-3) << method;
}

TEST(HardCase, float_stagnates_where_a_step_is_below_half_an_ulp) {
    const CaseTable table("stagnation");
    for (const char* method : fixed_steps) {
        EXPECT_EQ(table.cell(method, 1), "0.000") << method;
        EXPECT_EQ(table.cell(method, 2), "1.000") << method;
        EXPECT_EQ(table.cell(method, 3), "1.000") << method;
    }
    EXPECT_EQ(table.cell("dopri5", 1), "1.000");  // long steps
}

/// Subnormal numbers among 2000 steps of a damped oscillator in float.
int subnormals(bool flushed) {
    std::optional<FlushSubnormals> flush;
    if (flushed) flush.emplace();
    const Segment segment(run_of("oscillator", "velocity-verlet", Precision::float_, 0.1, {{"c", 1}}));
    State<double> state;
    int count = 0;
    for (int step = 0; step < 2000; ++step) {
        segment.stepper->advance(1);
        segment.stepper->synchronised(state);
        const double x = std::abs(state.displacement.x()[1]);
        count += x > 0 && x < static_cast<double>(std::numeric_limits<float>::min()) ? 1 : 0;
    }
    return count;
}

TEST(HardCase, decaying_motion_is_never_subnormal) {
    const CaseTable table("subnormal");
    for (const MethodCase& c : working_methods()) {
        EXPECT_THAT(table.cell(c.id(), 1), StartsWith("0 subnormal")) << c.id();
        EXPECT_THAT(table.cell(c.id(), 2), StartsWith("0 subnormal")) << c.id();
    }
    EXPECT_EQ(subnormals(true), 0);
    EXPECT_GT(subnormals(false), 100);  // the partner: without flushing
}

TEST(HardCase, chaos_destroys_all_digits) {
    const CaseTable table("chaos");
    for (const char* method : {"srkn-11b", "kahan-li-8", "rkn-12-10", "gauss-16"}) {
        EXPECT_LT(table.number(method, 1), 1e-11) << method;
        EXPECT_GT(table.number(method, 4), 1e-6) << method;
    }
    for (const char* method : {"rk4", "pefrl", "velocity-verlet"}) EXPECT_GT(table.number(method, 4), 0.1) << method;
}

}  // namespace
}  // namespace steplab::test
