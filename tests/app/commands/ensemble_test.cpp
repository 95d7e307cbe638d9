#include "sim/ensemble/ensemble.hpp"

#include "app/program.hpp"
#include "app/tables.hpp"
#include "io/files.hpp"
#include "sim/ensemble/parameter_range.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace steplab {
namespace {

using Json = nlohmann::json;
using testing::HasSubstr;

/// `steplab run --model chain --method euler` with more of these.
Outcome run_chain(std::vector<std::string> more, const Surroundings& surroundings = {}) {
    std::vector<std::string> all{"run", "--model", "chain", "--method", "euler"};
    all.insert(all.end(), more.begin(), more.end());
    return run_program(all, surroundings);
}

/// The same run alone, as its summary.
Json alone(double k, double dt, const std::vector<std::string>& more) {
    std::vector<std::string> all{"--set", fmt::format("k={}", k), "--dt", fmt::format("{}", dt), "--summary", "-"};
    all.insert(all.end(), more.begin(), more.end());
    return Json::parse(run_chain(all).out);
}

TEST(EnsembleCommand, gives_every_run_the_result_of_the_run_alone) {
    for (const std::string precision : {"float", "double"}) {
        const std::vector<std::string> common{"--until", "20", "--every", "30", "--precision", precision};
        std::vector<std::string> all{"--ensemble", "19",           "--spread",  "k=1:2",
                                     "--spread",   "dt=0.02:0.05", "--summary", "-"};
        all.insert(all.end(), common.begin(), common.end());
        const Outcome outcome = run_chain(all);
        ASSERT_EQ(outcome.code, 0) << outcome.err;
        const Json json = Json::parse(outcome.out);
        EXPECT_EQ(json["model"], "chain");
        EXPECT_EQ(json["method"], "euler");
        EXPECT_EQ(json["precision"], precision);
        EXPECT_EQ(json["ensemble"], 19);
        EXPECT_EQ(json["diverged"], 0);
        EXPECT_EQ(json["spread"],
                  Json::parse(R"([{"name":"k","from":1.0,"to":2.0},{"name":"dt","from":0.02,"to":0.05}])"));
        ASSERT_EQ(json["runs"].size(), 19u);
        for (const std::size_t i : {0U, 7U, 18U}) {
            const Json& run = json["runs"][i];
            const double k = ParameterRange{"k", 1, 2}.value(i, 19), dt = ParameterRange{"dt", 0.02, 0.05}.value(i, 19);
            EXPECT_EQ(run["run"], i);
            EXPECT_EQ(run["set"]["k"], k);
            EXPECT_EQ(run["set"]["dt"], dt);
            Json expected = alone(k, dt, common);
            for (const char* const shared :
                 {"version", "commit", "model", "method", "precision", "parameters", "wall_seconds"})
                expected.erase(shared);
            EXPECT_TRUE(expected.contains("error"));
            expected.erase("notes");
            Json result = run;
            result.erase("run"), result.erase("set");
            EXPECT_EQ(result, expected);
        }
    }
}

// The work of drag is counted by splittings from outside, by Runge-Kutta methods beside their stages; ias15 has steps
// of its own. What no method counts is a change of energy, no error.
TEST(EnsembleCommand, drag_is_no_error_of_energy) {
    for (const char* const method : {"velocity-verlet", "rk4", "ias15", "stoermer"}) {
        for (const bool rows : {false, true}) {
            const TemporaryFolder folder;
            const std::vector<std::string> common{"--model", "chain", "--set",     "n=5",     "--method",
                                                  method,    "--dt",  "0.02",      "--steps", "100",
                                                  "--every", "10",    "--summary", "-"};
            const auto json_of = [&](std::vector<std::string> more) {
                more.insert(more.begin(), "run");
                more.insert(more.end(), common.begin(), common.end());
                return Json::parse(run_program(more, {.folder = folder.path()}).out);
            };
            std::vector<std::string> all{"--ensemble", "9", "--spread", "c=0.1:0.3"};
            if (rows) all.insert(all.end(), {"--series", "e.csv"});
            const Json json = json_of(all);
            for (const std::size_t i : {0U, 4U, 8U}) {
                const Json &run = json["runs"][i],
                           one = json_of({"--set", fmt::format("c={}", ParameterRange{"c", 0.1, 0.3}.value(i, 9))});
                for (const char* const field : {"hash", "evaluations", "energy_error", "drag_work", "energy_change"})
                    EXPECT_EQ(run.value(field, Json()), one.value(field, Json())) << method << ' ' << field << ' ' << i;
                EXPECT_EQ(run["energy_error"].is_null(), method == std::string("stoermer"));
            }
            if (!rows) continue;
            const std::vector<std::string> lines = split(text_of(folder.file("e.csv")), '\n');
            const std::vector<std::string> names = split(lines[0], ','), cells = split(lines[1], ',');
            const auto column = std::find(names.begin(), names.end(), "energy_error") - names.begin();
            EXPECT_EQ(cells.at(static_cast<std::size_t>(column)).empty(), method == std::string("stoermer"));
        }
    }
}

TEST(EnsembleCommand, an_end_that_is_not_the_one_asked_for_is_a_note) {
    const Outcome outcome =
        run_chain({"--ensemble", "3", "--spread", "k=1:2", "--until", "1", "--dt", "0.3", "--summary", "-"});
    const Json json = Json::parse(outcome.out);
    ASSERT_EQ(json["notes"].size(), 1U);
    const auto note = json["notes"][0].get<std::string>();
    EXPECT_EQ(note, "the longest run: 4 steps of dt = 0.3 s end at t = 1.2 s, not at 1 s");
    EXPECT_THAT(outcome.err, HasSubstr(note));
}

TEST(EnsembleCommand, rows_are_those_of_the_runs_behind_their_numbers) {
    const TemporaryFolder folder;
    const Surroundings here{.folder = folder.path()};
    const std::vector<std::string> common{"--steps", "7", "--every", "3", "--particles", "9,2", "--precision", "float"};
    std::vector<std::string> all{"--ensemble", "3",        "--spread",     "k=1:2",     "--out",
                                 "e.csv",      "--series", "e.series.csv", "--summary", "e.json"};
    all.insert(all.end(), common.begin(), common.end());
    ASSERT_EQ(run_chain(all, here).code, 0);
    std::string rows, series;
    for (const char* const k : {"1", "1.5", "2"}) {
        std::vector<std::string> one{"--set", fmt::format("k={}", k), "--out", "a.csv", "--series", "a.series.csv"};
        one.insert(one.end(), common.begin(), common.end());
        ASSERT_EQ(run_chain(one, here).code, 0);
        const auto add = [&](const std::string& file, std::string& text) {
            const std::vector<std::string> lines = split(text_of(folder.file(file)), '\n');
            const std::string run = k == std::string("1") ? "0" : k == std::string("1.5") ? "1" : "2";
            if (text.empty()) text = "run," + lines.front() + '\n';
            for (std::size_t i = 1; i < lines.size(); ++i) {
                if (!lines[i].empty()) text += run + ',' + lines[i] + '\n';
            }
        };
        add("a.csv", rows);
        add("a.series.csv", series);
    }
    EXPECT_EQ(text_of(folder.file("e.csv")), rows);
    EXPECT_EQ(text_of(folder.file("e.series.csv")), series);
    // with rows the runs are computed one by one, without them in SIMD lanes: the results are equal
    std::vector<std::string> plain{"--ensemble", "3", "--spread", "k=1:2", "--summary",   "-",
                                   "--steps",    "7", "--every",  "3",     "--precision", "float"};
    Json with = Json::parse(text_of(folder.file("e.json"))), without = Json::parse(run_chain(plain).out);
    with.erase("wall_seconds"), without.erase("wall_seconds");
    EXPECT_EQ(with, without);
}

TEST(EnsembleCommand, ends_with_4_if_a_run_diverged_and_names_the_first) {
    const Outcome outcome = run_chain({"--ensemble", "40", "--spread", "dt=0.5:3", "--summary", "-"});
    EXPECT_EQ(outcome.code, 4);
    const Json json = Json::parse(outcome.out);
    std::size_t diverged = 0, first = 40;
    for (std::size_t i = 40; i-- > 0;) {
        if (json["runs"][i]["status"] != "diverged") continue;
        ++diverged, first = i;
    }
    EXPECT_GT(diverged, 0u);
    EXPECT_LT(diverged, 40u);
    EXPECT_EQ(json["diverged"], diverged);
    EXPECT_THAT(outcome.err,
                HasSubstr(fmt::format("{} of 40 runs diverged, the first of them run {}", diverged, first)));
}

TEST(EnsembleCommand, prints_a_summary) {
    const Outcome outcome = run_chain({"--ensemble", "20", "--spread", "v0=0:1", "--steps", "10"});
    EXPECT_EQ(outcome.code, 0);
    for (const char* const words : {"20 runs of chain with euler", "v0", "0 to 1", "200 in total", "ok"})
        EXPECT_THAT(outcome.out, HasSubstr(words));
}

TEST(EnsembleCommand, without_a_range_all_runs_are_equal) {
    const Json json = Json::parse(run_chain({"--ensemble", "9", "--steps", "10", "--summary", "-"}).out);
    for (const Json& run : json["runs"]) EXPECT_EQ(run["hash"], json["runs"][0]["hash"]);
}

}  // namespace
}  // namespace steplab
