#include "app/folder_watch.hpp"
#include "app/program.hpp"
#include "app/tables.hpp"
#include "io/files.hpp"
#include "lab/study/study.hpp"
#include "sim/catalogue.hpp"

#include <gmock/gmock.h>

#include <csignal>
#include <filesystem>
#include <map>
#include <sys/inotify.h>

namespace steplab {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

std::vector<std::string> report(const std::string& folder) {
    return {"report",   "--quick", "--model",  "chain", "--time",   "5",        "--method", "verlet",
            "--method", "rk4",     "--method", "pefrl", "--method", "gauss-16", "--out",    folder};
}

/// The columns that do not depend on the time of each run: all but wall_s, by method, precision, dt and tolerance.
std::map<std::string, std::string> facts(const std::string& file) {
    std::map<std::string, std::string> facts;
    for (const auto& row : table(text_of(file)).rows) {
        const std::string which = row[1] + ' ' + row[2] + ' ' + row[3] + ' ' + (row.size() > 12 ? row[12] : "");
        facts[which] = row[4] + ' ' + row[5] + ' ' + row[7] + ' ' + row[8] + ' ' + row[9] + ' ' + row[10];
    }
    return facts;
}

TEST(Report, writes_a_table_and_a_page_and_no_messages) {
    const TemporaryFolder folder;
    const Outcome outcome = run_program(report(folder.file("out")));
    EXPECT_EQ(outcome.code, 0);
    EXPECT_THAT(without_progress(outcome.err), IsEmpty());
    EXPECT_THAT(outcome.out, HasSubstr("report.html"));
    EXPECT_THAT(text_of(folder.file("out/report.html")), HasSubstr("Error against time, float"));
    const CsvTable runs = table(text_of(folder.file("out/speed_error.csv")));
    EXPECT_THAT(runs.head, testing::StartsWith("model,method,precision,dt,steps,evaluations,wall_s,error,energy_error,"
                                               "status,hash"));
    for (const char* method : {"verlet", "rk4", "pefrl", "gauss-16"}) {
        EXPECT_TRUE(std::any_of(runs.rows.begin(), runs.rows.end(), [&](const auto& row) { return row[1] == method; }));
    }
    for (const auto& row : runs.rows) EXPECT_EQ(row[9] == "diverged", row[6].empty());  // failed runs have no time
}

TEST(Report, of_all_models_says_what_it_leaves_out) {
    const TemporaryFolder folder;
    const std::vector<std::string> all{"report", "--quick", "--method", "euler", "--precision",
                                       "double", "--time",  "0.05",     "--out", folder.file("all")};
    const Outcome whole = run_program(all);
    EXPECT_EQ(whole.code, 0);
    EXPECT_EQ(without_progress(whole.err), "steplab report: note: not in it: " + left_out_text() + "\n");
    EXPECT_THAT(text_of(folder.file("all/report.html")), HasSubstr("Not in this report: crystal ("));
    EXPECT_EQ(run_program(report(folder.file("one"))).code, 0);
    EXPECT_THAT(text_of(folder.file("one/report.html")), testing::Not(HasSubstr("Not in this report")));
}

/// A report of which some is measured, and the rest still to be done.
class BegunReport {
public:
    explicit BegunReport(const std::string& folder) : watch_(measured_in(folder)), program_(report(folder)) {
        watch_.wait_for_a_file();
    }
    RunningProgram& program() { return program_; }

private:
    static std::string measured_in(const std::string& folder) {
        std::filesystem::create_directories(folder + "/.measured");
        return folder + "/.measured";
    }

    FolderWatch watch_;
    RunningProgram program_;
};

// The kept state appears when the first of eight series is measured: the signal comes while most of the work is still
// to be done.
TEST(Report, resumes_after_an_interruption_with_the_same_result) {
    const TemporaryFolder folder;
    BegunReport first(folder.file("out"));
    first.program().send(SIGINT);
    const Outcome interrupted = first.program().wait();
    EXPECT_EQ(interrupted.code, 128 + SIGINT);
    EXPECT_EQ(interrupted.signal, 0);
    EXPECT_THAT(interrupted.err, HasSubstr("to resume"));
    EXPECT_FALSE(std::filesystem::exists(folder.file("out/report.html")));
    EXPECT_TRUE(std::filesystem::exists(folder.file("out/.measured/chain.json")));

    EXPECT_EQ(run_program(report(folder.file("out"))).code, 0);
    EXPECT_EQ(run_program(report(folder.file("at-once"))).code, 0);
    const auto resumed = facts(folder.file("out/speed_error.csv")),
               at_once = facts(folder.file("at-once/speed_error.csv"));
    std::size_t both = 0;
    for (const auto& [which, what] : at_once) {
        const auto found = resumed.find(which);
        if (found == resumed.end()) continue;  // the clock decides how far down a series goes
        EXPECT_EQ(found->second, what) << which;
        ++both;
    }
    EXPECT_GT(2 * both, at_once.size());
    EXPECT_FALSE(std::filesystem::exists(folder.file("out/.measured")));
}

TEST(Report, refuses_a_model_that_it_has_no_scene_of_with_the_reason) {
    const TemporaryFolder folder;
    for (const LeftOut& scene : left_out_of_plans()) {
        const Outcome outcome =
            run_program({"report", "--model", std::string(scene.model), "--out", folder.file("out")});
        EXPECT_EQ(outcome.code, 2);
        EXPECT_THAT(outcome.err, HasSubstr(std::string(scene.reason)));
        EXPECT_FALSE(std::filesystem::exists(folder.file("out")));
    }
}

TEST(Report, has_a_scene_of_every_model_or_names_it_as_left_out) {
    for (const Model& model : models()) {
        const auto plans = default_plans(true);
        const bool planned = std::any_of(plans.begin(), plans.end(),
                                         [&](const StudyPlan& plan) { return plan.scene.model == model.info.id; });
        const bool named = left_out_text().find(model.info.id) != std::string::npos;
        EXPECT_NE(planned, named) << model.info.id;
    }
}

// The work of a run is its time by the rate of its fastest vibration and the number of its forces.
TEST(Report, a_quick_one_takes_as_much_of_a_run_as_there_is_time_for) {
    const auto time_of = [](double dim, double whole) {
        RunDescription mesh = describe("mesh");
        mesh.scene.set("dim", dim);
        return quick_time(plan_for(mesh, whole, true));
    };
    EXPECT_EQ(time_of(10, 20), 20);
    const double most = time_of(10, 1e6);
    EXPECT_LT(most, 1e6);
    EXPECT_EQ(time_of(10, 1e7), most);
    EXPECT_NEAR(time_of(20, 1e6), most / 4, most / 20);  // the edge of a mesh has fewer springs
}

TEST(Report, of_another_program_in_the_same_folder_is_refused) {
    const TemporaryFolder folder;
    BegunReport first(folder.file("out"));
    const Outcome second = run_program(report(folder.file("out")));
    EXPECT_EQ(second.code, 3);
    EXPECT_THAT(second.err, HasSubstr("another report is being written there"));
    first.program().send(SIGKILL);
    EXPECT_EQ(first.program().wait().signal, SIGKILL);
    EXPECT_TRUE(std::filesystem::exists(folder.file("out/.measured/chain.json")));
    EXPECT_EQ(run_program(report(folder.file("out"))).code, 0) << "the killed one does not hold the folder";
}

TEST(Report, of_the_thesis_is_interrupted) {
    const TemporaryFolder folder;
    const FolderWatch watch(folder.path(), IN_CREATE);
    RunningProgram thesis({"report", "--thesis", "--out", folder.file("out")});
    watch.wait_for_a_file();  // it has begun
    thesis.send(SIGINT);
    const Outcome outcome = thesis.wait();
    EXPECT_EQ(outcome.code, 128 + SIGINT);
    EXPECT_FALSE(std::filesystem::exists(folder.file("out/thesis.html")));
}

TEST(Report, is_restricted_by_options) {
    const TemporaryFolder folder;
    const Outcome outcome =
        run_program({"report", "--quick", "--model", "oscillator", "--method", "rk4", "--precision", "float", "--time",
                     "3", "--set", "k=4", "--error", "1e-3", "--error", "0.1", "--out", folder.file("out")});
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    for (const auto& row : table(text_of(folder.file("out/speed_error.csv"))).rows) {
        EXPECT_EQ(row[0] + row[1] + row[2], "oscillatorrk4float");
        EXPECT_NEAR(number(row[3]) * number(row[4]), 3, 1e-6);
    }
    const std::string page = text_of(folder.file("out/report.html"));
    EXPECT_THAT(page, HasSubstr("error ≤ 0.1</th><th>error ≤ 0.001"));
    EXPECT_THAT(page, HasSubstr("k = 4"));
    EXPECT_THAT(page, testing::Not(HasSubstr("pefrl")));
}

TEST(Report, measures_scenes_of_ones_own_under_any_name) {
    const TemporaryFolder folder;
    const std::string scene = folder.file("two, \"springs\".toml");
    ASSERT_EQ(run_program({"export", "--model", "chain", "--set", "n=3", "--to", "scene", "--out", scene}).code, 0);
    std::vector<std::string> words{"report",  "--scene",  scene,   "--scene",         "kepler-ellipse",
                                   "--quick", "--method", "rk4",   "--precision",     "double",
                                   "--time",  "2",        "--out", folder.file("out")};
    const Outcome outcome = run_program(words);
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(without_progress(outcome.err), "");
    const std::string rows = text_of(folder.file("out/speed_error.csv"));
    EXPECT_THAT(rows, HasSubstr("\n\"two, \"\"springs\"\"\",rk4,double,"));
    EXPECT_THAT(rows, HasSubstr("\nkepler-ellipse,rk4,double,"));
    EXPECT_THAT(text_of(folder.file("out/report.html")), HasSubstr("two, &quot;springs&quot;</h2>"));
    words.insert(words.begin() + 1, {"--scene", "kepler-ellipse"});
    EXPECT_EQ(run_program(words).code, 2) << "two of one name";
}

TEST(Advise, names_a_command_that_keeps_the_error) {
    const Outcome outcome = run_program({"advise", "--model", "chain", "--until", "20", "--error", "1e-7"});
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_THAT(without_progress(outcome.err), IsEmpty());
    for (const char* word : {"steplab run --model chain", "verified", "rk4", "NEXT BEST", "takes about"})
        EXPECT_THAT(outcome.out, HasSubstr(word));
    const std::size_t begin = outcome.out.find("run --model"), end = outcome.out.find('\n', begin);
    std::vector<std::string> command = split(outcome.out.substr(begin, end - begin), ' ');
    command.insert(command.end(), {"--out", "-", "--summary", "/dev/null"});
    EXPECT_EQ(run_program(command).code, 0);
}

TEST(Advise, keeps_to_the_precision_and_method_that_are_named) {
    const Outcome both = run_program({"advise", "--model", "chain", "--until", "5", "--error", "1e-3", "--precision",
                                      "float", "--method", "verlet"});
    ASSERT_EQ(both.code, 0) << both.err;
    EXPECT_THAT(both.out, HasSubstr("--method verlet --precision float"));
    EXPECT_THAT(both.out, testing::Not(HasSubstr("NEXT BEST")));
    const Outcome impossible = run_program({"advise", "--model", "chain", "--until", "5", "--error", "1e-9",
                                            "--precision", "float", "--method", "verlet"});
    EXPECT_EQ(impossible.code, 2);
    EXPECT_THAT(impossible.err, HasSubstr("the smallest was"));
}

}  // namespace
}  // namespace steplab
