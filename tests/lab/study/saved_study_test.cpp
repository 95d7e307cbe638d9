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

TEST(SavedStudy, is_found_again) {
    const TemporaryFolder folder;
    const StudyPlan plan = small_plan({"euler", "rk4"});
    EXPECT_FALSE(SavedStudies(folder.path()).find(plan));
    SavedStudies(folder.path()).save(plan, state());
    const auto found = SavedStudies(folder.path()).find(plan);
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

TEST(SavedStudy, of_another_plan_is_ignored) {
    const TemporaryFolder folder;
    const SavedStudies saved(folder.path());
    const StudyPlan plan = small_plan({"euler", "rk4"});
    saved.save(plan, state());
    StudyPlan other = plan;
    other.time = 6;
    EXPECT_FALSE(saved.find(other));
    other = plan;
    other.method_settings["substeps"] = 3;
    EXPECT_FALSE(saved.find(other));
    other = plan;
    other.methods.pop_back();
    EXPECT_FALSE(saved.find(other));
    other = plan;
    other.scene.scene.set("k", 2);
    EXPECT_FALSE(saved.find(other));
    EXPECT_TRUE(saved.find(plan));
}

// After a full disk or a crash: a file is used only if it is complete.
TEST(SavedStudy, truncated_at_any_byte_is_ignored) {
    const TemporaryFolder folder;
    const SavedStudies saved(folder.path());
    const StudyPlan plan = small_plan({"euler", "rk4"});
    saved.save(plan, state());
    const std::string file = folder.file(".measured/chain.json"), whole = text_of(file);
    for (std::size_t bytes = 0; bytes + 1 < whole.size(); ++bytes) {  // its line end says nothing
        put_text(file, std::string_view(whole).substr(0, bytes));
        EXPECT_FALSE(saved.find(plan)) << bytes << " of " << whole.size();
    }
    put_text(file, whole);
    EXPECT_TRUE(saved.find(plan));
}

TEST(SavedStudy, with_other_contents_is_ignored) {
    const TemporaryFolder folder;
    const SavedStudies saved(folder.path());
    const StudyPlan plan = small_plan({"rk4"});
    for (const char* text : {"{}", "[]", "3", "{\"key\":3}", "null", "\"key\""}) {
        put_text(folder.file(".measured/chain.json"), text);
        EXPECT_FALSE(saved.find(plan)) << text;
    }
}

/// Ends the report after a number of calls of its progress, as an interruption does.
struct Stopped {};

TEST(Report, that_was_stopped_is_resumed_and_measures_no_series_twice) {
    const TemporaryFolder folder;
    const ReportRequest request{.folder = folder.path(), .plans = {small_plan({"rk4", "pefrl", "verlet"})}};
    int calls = 0;
    EXPECT_THROW(write_report(request,
                              [&](double part, const std::string&) {
                                  if (part > 0.3 && ++calls > 0) throw Stopped();
                              }),
                 Stopped);
    const auto saved = SavedStudies(folder.path()).find(request.plans[0]);
    ASSERT_TRUE(saved);
    EXPECT_GE(saved->series.series, 1u);
    EXPECT_FALSE(saved->series.timed);
    double first = 1;
    write_report(request, [&](double part, const std::string&) {
        if (part > 0 && first == 1) first = part;
    });
    EXPECT_GT(first, 0.2);  // it resumes where it stopped
    EXPECT_TRUE(std::filesystem::exists(folder.file("report.html")));
    EXPECT_FALSE(std::filesystem::exists(folder.file(".measured")));
}

TEST(Report, of_a_folder_that_cannot_be_created_is_refused) {
    const TemporaryFolder folder;
    put_text(folder.file("file"), "");
    EXPECT_THROW(write_report({.folder = folder.file("file/out"), .plans = {}}, [](double, const std::string&) {}),
                 FileError);
}

}  // namespace
}  // namespace steplab::test
