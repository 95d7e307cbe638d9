// A summary is enough to repeat its run: with the options that it describes, and the files that it carries.
#include "app/program.hpp"
#include "io/files.hpp"
#include "sim/catalogue.hpp"
#include "support/runs.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace steplab {
namespace {

using Json = nlohmann::json;
using SummaryWords = std::vector<std::string>;

std::string text(const Json& value) { return value.is_string() ? value.get<std::string>() : value.dump(); }

void append(SummaryWords& words, const SummaryWords& more) { words.insert(words.end(), more.begin(), more.end()); }

/// Writes the files of the scene into the folder. Returns the option for it.
SummaryWords scene_words(const Json& summary, const TemporaryFolder& folder) {
    if (!summary.contains("scene")) return {"--model", text(summary.at("model"))};
    for (const Json& part : summary.at("scene").at("files")) {
        const std::string name = part.at("name");
        put_text(folder.file(name.empty() ? "scene.toml" : name), part.at("content").get<std::string>());
    }
    return {"--scene", folder.file("scene.toml")};
}

/// The same of where the run starts.
SummaryWords start_words(const Json& summary, const TemporaryFolder& folder) {
    SummaryWords words;
    if (!summary.contains("start")) return words;
    const Json& start = summary.at("start");
    if (start.at("reverse")) words.push_back("--reverse");
    if (!start.contains("from")) return words;
    put_text(folder.file("start.csv"), start.at("from").at("content").get<std::string>());
    append(words, {"--from", folder.file("start.csv")});
    return words;
}

/// The command line that a summary describes.
SummaryWords words_of(const Json& summary, const TemporaryFolder& folder) {
    SummaryWords words{"run", "--summary", "-"};
    append(words, scene_words(summary, folder));
    append(words, start_words(summary, folder));
    for (const char* name : {"method", "precision", "dt"})
        append(words, {std::string("--") + name, text(summary.at(name))});
    const char* end = summary.contains("until") ? "until" : "steps";
    append(words, {std::string("--") + end, text(summary.at(end))});
    for (const auto& [name, value] : summary.at("parameters").items())
        append(words, {"--set", name + "=" + text(value)});
    return words;
}

/// The run, and the one that its summary describes, are the same.
Json expect_repeatable(SummaryWords options) {
    const TemporaryFolder folder;
    options.insert(options.begin(), {"run", "--summary", "-"});
    const Outcome outcome = run_program(options);
    EXPECT_EQ(outcome.code, 0) << testing::PrintToString(options) << outcome.err;
    if (outcome.code != 0) return {};
    Json first = Json::parse(outcome.out);
    const SummaryWords words = words_of(first, folder);
    const Outcome repeated = run_program(words);
    EXPECT_EQ(repeated.code, 0) << testing::PrintToString(words) << repeated.err;
    if (repeated.code != 0) return first;
    const Json again = Json::parse(repeated.out);
    for (const char* key : {"hash", "parameters", "steps", "time"})
        EXPECT_EQ(first.at(key), again.at(key)) << key << testing::PrintToString(words);
    return first;
}

class SummaryOf : public testing::TestWithParam<test::MethodCase> {
protected:
    SummaryWords method_words() const {
        return {"--method", GetParam().id(), "--precision", std::string(id(GetParam().precision))};
    }
};

TEST_P(SummaryOf, each_run_is_enough_to_repeat_it) {
    for (const Model* const model : test::models_for(GetParam().info->id, GetParam().precision)) {
        for (const SummaryWords& end : {SummaryWords{"--dt", "0.013", "--steps", "3"},
                                        {"--dt", "0.1", "--until", "0.25"},
                                        {"--dt", "0.1", "--until", "0.3"}}) {
            SummaryWords options = method_words();
            append(options, end);
            append(options, {"--model", std::string(model->info.id)});
            if (model->info.id == "mesh") append(options, {"--set", "kick=corner"});
            expect_repeatable(options);
        }
    }
}

TEST_P(SummaryOf, scene_files_and_starts_is_enough_to_repeat_it) {
    const TemporaryFolder folder;
    SummaryWords before = method_words();
    append(before,
           {"run", "--scene", "beats", "--dt", "0.02", "--until", "0.05", "--out", folder.file("a.trajectory")});
    std::rotate(before.begin(), before.begin() + 4, before.end());
    const Outcome made = run_program(before);
    if (made.code == 2) return;  // a method of one model alone
    ASSERT_EQ(made.code, 0) << made.err;
    for (const SummaryWords& start : {SummaryWords{},
                                      {"--reverse"},
                                      {"--from", folder.file("a.trajectory")},
                                      {"--from", folder.file("a.trajectory") + ":0", "--reverse", "--set", "K=0.6"}}) {
        SummaryWords options = method_words();
        append(options, {"--scene", "beats", "--dt", "0.02", "--until", "0.05"});
        append(options, start);
        const Json summary = expect_repeatable(options);
        EXPECT_TRUE(summary.contains("scene"));
        EXPECT_EQ(summary.contains("start"), !start.empty());
    }
}

INSTANTIATE_TEST_SUITE_P(Methods, SummaryOf, testing::ValuesIn(test::all_methods()), test::case_name);

TEST(Summary, has_an_end_time_where_the_number_of_steps_does_not_say_it) {
    const auto summary_of = [](const SummaryWords& more) {
        SummaryWords words{"run", "--model", "chain", "--dt", "0.1", "--summary", "-"};
        append(words, more);
        return Json::parse(run_program(words).out);
    };
    const Json own = summary_of({"--method", "dopri5", "--until", "0.25"});
    EXPECT_EQ(own.at("until"), 0.25);
    EXPECT_EQ(own.at("steps"), 3);
    const Json whole = summary_of({"--method", "dopri5", "--steps", "3"});
    EXPECT_FALSE(whole.contains("until"));
    EXPECT_NE(whole.at("hash"), own.at("hash"));
    EXPECT_FALSE(summary_of({"--method", "rk4", "--until", "0.25"}).contains("until"));
}

TEST(Summary, each_run_of_an_ensemble_has_its_end_time) {
    const Json all = Json::parse(run_program({"run", "--model", "chain", "--method", "dopri5", "--until", "0.25",
                                              "--ensemble", "2", "--spread", "dt=0.1:0.2", "--summary", "-"})
                                     .out);
    for (const Json& run : all.at("runs")) {
        EXPECT_EQ(run.at("until"), 0.25);
        const Json alone = expect_repeatable({"--model", "chain", "--method", "dopri5", "--dt",
                                              text(run.at("set").at("dt")), "--until", text(run.at("until"))});
        EXPECT_EQ(alone.at("hash"), run.at("hash"));
    }
}

}  // namespace
}  // namespace steplab
