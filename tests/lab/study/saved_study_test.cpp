#include "lab/study/saved_study.hpp"

#include "core/error.hpp"
#include "io/files.hpp"
#include "lab/report/report.hpp"
#include "lab/studies.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

namespace steplab::test {
namespace {

StudyState state() {
    StudyState state{.reference = "exact solution", .reference_error = 1e-16, .series = {}, .limits = {}};
    state.series = {.runs = {run_with("rk4", 0.1, 1e-5, 3e-6), diverged("euler", 1)},
                    .cut = {{"rk4", Precision::float_}},
                    .series = 2,
                    .ahead = {{4, {{run_with("pefrl", 0.1, 1e-7, 5e-6)}, true}}},
                    .timed = true};
    state.limits = {
        {.description = describe("chain", "rk4"), .omega_max = 2, .theory = infinity, .measured = {}, .note = "why"}};
    return state;
}

TEST(KeptStudy, is_found_again) {
    const TemporaryFolder folder;
    const StudyPlan plan = small_plan({"euler", "rk4"});
    EXPECT_FALSE(KeptStudies(folder.path()).find(plan));
    KeptStudies(folder.path()).keep(plan, state());
    const auto found = KeptStudies(folder.path()).find(plan);
    ASSERT_TRUE(found);
    EXPECT_EQ(found->reference, "exact solution");
    EXPECT_EQ(found->series.series, 2u);
    EXPECT_TRUE(found->series.timed);
    ASSERT_EQ(found->series.ahead.size(), 1u);
    const MeasuredSeries& ahead = found->series.ahead.at(4);
    ASSERT_EQ(ahead.runs.size(), 1u);
    EXPECT_EQ(ahead.runs[0].error, 1e-7);
    EXPECT_TRUE(ahead.cut);
    ASSERT_EQ(found->series.runs.size(), 2u);
    EXPECT_EQ(found->series.runs[0].error, 1e-5);
    EXPECT_TRUE(found->series.runs[1].diverged());
    ASSERT_EQ(found->series.cut.size(), 1u);
    EXPECT_EQ(found->series.cut[0].method, "rk4");
    EXPECT_EQ(found->series.cut[0].precision, Precision::float_);
    ASSERT_TRUE(found->limits);
    EXPECT_EQ(found->limits->front().theory, infinity);
    EXPECT_FALSE(found->limits->front().measured);
}

TEST(KeptStudy, of_another_plan_counts_for_nothing) {
    const TemporaryFolder folder;
    const KeptStudies kept(folder.path());
    const StudyPlan plan = small_plan({"euler", "rk4"});
    kept.keep(plan, state());
    StudyPlan other = plan;
    other.time = 6;
    EXPECT_FALSE(kept.find(other));
    other = plan;
    other.method_settings["substeps"] = 3;
    EXPECT_FALSE(kept.find(other));
    other = plan;
    other.methods.pop_back();
    EXPECT_FALSE(kept.find(other));
    other = plan;
    other.scene.scene.set("k", 2);
    EXPECT_FALSE(kept.find(other));
    EXPECT_TRUE(kept.find(plan));
}

// A disk that was full, a machine that went down: whatever is left of the file, it is taken whole or not at all.
TEST(KeptStudy, cut_off_at_any_byte_counts_for_nothing) {
    const TemporaryFolder folder;
    const KeptStudies kept(folder.path());
    const StudyPlan plan = small_plan({"euler", "rk4"});
    kept.keep(plan, state());
    const std::string file = folder.file(".measured/chain.json"), whole = text_of(file);
    for (std::size_t bytes = 0; bytes < whole.size(); ++bytes) {
        put_text(file, std::string_view(whole).substr(0, bytes));
        EXPECT_FALSE(kept.find(plan)) << bytes << " of " << whole.size();
    }
    put_text(file, whole);
    EXPECT_TRUE(kept.find(plan));
}

TEST(KeptStudy, that_is_something_else_counts_for_nothing) {
    const TemporaryFolder folder;
    const KeptStudies kept(folder.path());
    const StudyPlan plan = small_plan({"rk4"});
    for (const char* text : {"{}", "[]", "3", "{\"key\":3}", "null", "\"key\""}) {
        put_text(folder.file(".measured/chain.json"), text);
        EXPECT_FALSE(kept.find(plan)) << text;
    }
}

/// Ends the report after so many calls of its progress, as an interruption does.
struct Stopped {};

TEST(Report, that_was_stopped_goes_on_and_measures_no_series_twice) {
    const TemporaryFolder folder;
    const ReportRequest request{.folder = folder.path(), .plans = {small_plan({"rk4", "pefrl", "verlet"})}};
    int calls = 0;
    EXPECT_THROW(write_report(request,
                              [&](double part, const std::string&) {
                                  if (part > 0.3 && ++calls > 0) throw Stopped();
                              }),
                 Stopped);
    const auto kept = KeptStudies(folder.path()).find(request.plans[0]);
    ASSERT_TRUE(kept);
    EXPECT_GE(kept->series.series, 1u);
    EXPECT_FALSE(kept->series.timed);
    double first = 1;
    write_report(request, [&](double part, const std::string&) {
        if (part > 0 && first == 1) first = part;
    });
    EXPECT_GT(first, 0.2);  // it begins where it was
    EXPECT_TRUE(std::filesystem::exists(folder.file("report.html")));
    EXPECT_FALSE(std::filesystem::exists(folder.file(".measured")));
}

TEST(Report, of_a_folder_that_cannot_be_made_is_refused) {
    const TemporaryFolder folder;
    put_text(folder.file("file"), "");
    EXPECT_THROW(write_report({.folder = folder.file("file/out"), .plans = {}}, [](double, const std::string&) {}),
                 FileError);
}

}  // namespace
}  // namespace steplab::test
