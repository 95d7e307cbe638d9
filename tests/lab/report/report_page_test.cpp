#include "lab/report/report_page.hpp"

#include "lab/report/figures.hpp"
#include "lab/studies.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <regex>
#include <string>

namespace steplab::test {
namespace {

using testing::HasSubstr;
using testing::Not;

const Circumstances made{"9.8.7", "c0ffee1", "a compiler", "a machine", "2026-01-02"};

/// Errors of methods of order 1, 4 and 4, made by hand: pefrl is 3 times as fast as rk4.
Study study() {
    Study study{small_plan({"euler", "rk4", "pefrl"}), "exact solution", 1e-16, {}, {}, {}};
    study.plan.precisions = {Precision::double_, Precision::float_};
    for (const Precision precision : study.plan.precisions) {
        const double rounding = precision == Precision::float_ ? 1e-6 : 1e-13;
        for (const double dt : {0.5, 0.25, 0.125, 0.0625, 0.03125}) {
            study.runs.push_back(run_with("euler", dt, 0.1 * dt + rounding, 2e-6 / dt));
            study.runs.push_back(run_with("rk4", dt, 0.01 * std::pow(dt, 4) + rounding, 3e-6 / dt));
            study.runs.push_back(run_with("pefrl", dt, 0.01 * std::pow(dt, 4) + rounding, 1e-6 / dt));
            for (std::size_t last = study.runs.size() - 3; last < study.runs.size(); ++last)
                study.runs[last].run.precision = precision;
        }
    }
    for (const std::string& method : study.plan.methods) {
        study.limits.push_back({.description = describe("chain", method),
                                .omega_max = 2,
                                .theory = 1.4142,
                                .measured = 1.4139,
                                .note = "a note on " + method});
    }
    return study;
}

std::string page_of(const Study& study) { return report_page({study}, std::vector{1e-2, 1e-4}, made); }

std::size_t count(const std::string& text, const std::string& what) {
    std::size_t found = 0;
    for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1)) ++found;
    return found;
}

TEST(ReportPage, names_the_program_and_the_machine) {
    const std::string page = page_of(study());
    for (const char* word : {"9.8.7", "c0ffee1", "a compiler", "a machine", "2026-01-02"})
        EXPECT_THAT(page, HasSubstr(word));
}

TEST(ReportPage, answers_in_a_sentence) {
    const std::string page = page_of(study());
    EXPECT_THAT(page, HasSubstr("For an error of 1e-4: pefrl at dt 0.25 in "));
    EXPECT_THAT(page, HasSubstr("3 times faster than rk4."));
    EXPECT_THAT(page, HasSubstr("error ≤ 10⁻⁴"));
}

TEST(ReportPage, has_every_diagram_and_table) {
    const std::string page = page_of(study());
    for (const char* title :
         {"Error against time, double", "Error against evaluations, double", "Error against time, float",
          "Error against evaluations, float", "Energy error over time, double", "Pareto front", "Orders", "Stability"})
        EXPECT_THAT(page, HasSubstr(title));
    EXPECT_EQ(count(page, "<figure>"), 5u);
    EXPECT_EQ(count(page, "class=\"curve\" data-name=\"pefrl\""), 5u);
    for (const char* cell : {"<td>1.4142</td>", "<td>1.4139</td>", "a note on pefrl", "exact solution"})
        EXPECT_THAT(page, HasSubstr(cell));
}

// The partner of the test above: what was not measured is not on the page.
TEST(ReportPage, has_no_diagram_of_what_was_not_measured) {
    Study less = study();
    less.plan.precisions = {Precision::double_};
    std::erase_if(less.runs,
                  [](const auto& m) { return m.run.precision == Precision::float_ || m.run.method == "pefrl"; });
    less.limits.clear();
    const std::string page = page_of(less);
    EXPECT_THAT(page, Not(HasSubstr("Error against time, float")));
    EXPECT_EQ(count(page, "class=\"curve\" data-name=\"pefrl\""), 0u);
    EXPECT_THAT(page, Not(HasSubstr("1.4142")));
    EXPECT_THAT(page, HasSubstr("cannot run it"));
    less.cut = {{"pefrl", Precision::double_}};
    const std::string cut = page_of(less);
    EXPECT_THAT(cut, Not(HasSubstr("cannot run it")));
    EXPECT_THAT(cut, HasSubstr("takes too long"));
}

TEST(ReportPage, shows_the_orders_measured_by_the_runs) {
    const std::string page = page_of(study());
    EXPECT_TRUE(std::regex_search(page, std::regex(R"(rk4</span></td><td>4</td><td>(4.00|3.99)</td>)")));
}

TEST(ReportPage, never_shows_a_failed_run_as_a_fast_one) {
    Study failed = study();
    for (int i = 0; i < 3; ++i) failed.runs.push_back(diverged("euler", 1e-9));
    const std::string page = page_of(failed), without = page_of(study());
    EXPECT_EQ(count(page, "<td>1 ns</td>"), 0u);
    const auto answers = [](const std::string& text) { return text.substr(0, text.find("<h3>Orders")); };
    EXPECT_EQ(answers(page), answers(without));
    EXPECT_THAT(page, HasSubstr("<td>13</td><td>3</td>"));  // counted
}

TEST(ReportPage, names_the_curves_that_were_cut_by_time) {
    Study cut = study();
    cut.plan.most_seconds_a_run = 0.002;
    cut.cut = {{"euler", Precision::double_}, {"pefrl", Precision::double_}, {"rk4", Precision::float_}};
    const std::string page = std::regex_replace(page_of(cut), std::regex("<[^>]*>"), "");
    EXPECT_THAT(page, HasSubstr("would have taken more than 2 ms, not because smaller steps bring no further gain."));
    EXPECT_THAT(page, HasSubstr("In double: euler, pefrl. In float: rk4."));
    EXPECT_THAT(page_of(study()), Not(HasSubstr("would have taken")));
}

TEST(ReportPage, is_self_contained) {
    const std::string page = page_of(study());
    for (const char* word : {"src=", "<link", "@import", "url(", "http://www.g", "https:", "fetch("})
        EXPECT_THAT(page, Not(HasSubstr(word)));
    // every colour of a diagram is one that follows light and dark
    for (const char* colour : {"rgb(", "fill=\"#", "stroke=\"#"}) EXPECT_EQ(count(page, colour), 0u) << colour;
    EXPECT_GT(count(page, "fill=\"var(--"), 0u);
    EXPECT_THAT(page, HasSubstr("prefers-color-scheme: dark"));
    EXPECT_THAT(page, HasSubstr("</html>"));
}

TEST(ReportPage, colours_a_method_the_same_in_all_scenes_and_only_the_fastest) {
    const Study one = study();
    EXPECT_EQ(coloured_methods(one), (std::vector<std::string>{"pefrl", "rk4"}));
    const auto colours = method_colours({one, one});
    EXPECT_EQ(colours.at("rk4"), 0);
    EXPECT_EQ(colours.count("euler"), 0u);
}

}  // namespace
}  // namespace steplab::test
