#include "app/program.hpp"
#include "app/tables.hpp"
#include "core/precision.hpp"
#include "io/files.hpp"
#include "sim/catalogue.hpp"
#include "sim/run/run_description.hpp"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace steplab {
namespace {

using Json = nlohmann::json;
using testing::HasSubstr;

/// True if a line of the help has all these words.
bool has_line(const std::string& text, const std::vector<std::string>& words) {
    for (const std::string& line : split(text, '\n')) {
        if (std::all_of(words.begin(), words.end(),
                        [&](const auto& word) { return line.find(word) != std::string::npos; }))
            return true;
    }
    return false;
}

void expect_parameters(const std::string& help, std::span<const ParameterInfo> parameters) {
    for (const ParameterInfo& info : parameters) {
        const std::string value = "default " + format_value(info, info.default_value);
        EXPECT_TRUE(
            has_line(help, {' ' + std::string(info.name) + ' ', value, std::string(info.unit), range_text(info)}))
            << info.name << ", " << value << ' ' << info.unit << ", " << range_text(info) << " in\n"
            << help;
    }
}

template <class Entry>
void expect_entries(const std::string& list, std::span<const Entry> entries) {
    const Outcome outcome = run_program({"list", list});
    EXPECT_EQ(outcome.code, 0);
    EXPECT_EQ(outcome.err, "");
    for (const Entry& entry : entries) {
        EXPECT_TRUE(has_line(outcome.out, {std::string(entry.info.id) + "  ", std::string(entry.info.name) + ':'}))
            << entry.info.id;
        expect_parameters(outcome.out, entry.info.parameters);
    }
    EXPECT_FALSE(has_line(outcome.out, {"no such parameter"}));
}

TEST(List, of_one_kind_holds_every_parameter_with_default_unit_and_range) {
    expect_entries("models", models());
    expect_entries("methods", methods());
}

TEST(Help, begins_with_the_commands_and_leaves_the_catalogue_to_list) {
    for (const std::vector<std::string>& words : {std::vector<std::string>{"--help"},
                                                  {"-h"},
                                                  {"run", "--help"},
                                                  {"view", "--help"},
                                                  {"snapshot", "--help"},
                                                  {"record", "--help"}}) {
        const std::string help = run_program(words).out;
        EXPECT_TRUE(has_line(help, {"steplab list models", "steplab list methods"}));
        EXPECT_FALSE(has_line(help, {std::string(models().back().info.what.substr(0, 30))}));
        EXPECT_LE(split(help, '\n').size(), 70u);  // of view, which has the most options
    }
}

// The manual and the completions have the same texts.
TEST(Help, names_the_files_that_are_played) {
    for (const char* command : {"view", "snapshot", "record"}) {
        const std::string help = run_program({command, "--help"}).out;
        const std::size_t begin = help.find("--trajectory"), end = help.find("\n  --", begin);
        ASSERT_NE(begin, std::string::npos) << command;
        std::string words;
        for (const std::string& line : split(help.substr(begin, end - begin), '\n'))
            words += line.substr(std::min(line.size(), line.find_first_not_of(' '))) + ' ';
        EXPECT_NE(words.find("trajectory, CSV, extended XYZ or LAMMPS dump"), std::string::npos) << words;
    }
}

TEST(Help, names_defaults_and_commands) {
    const std::string help = run_program({"run", "--help"}).out;
    const RunDescription defaults = describe();
    EXPECT_TRUE(has_line(help, {"--model", "default " + defaults.model}));
    EXPECT_TRUE(has_line(help, {"--method", "default " + defaults.method}));
    EXPECT_TRUE(has_line(help, {"--precision", "float|double", "default " + std::string(id(defaults.precision))}));
    EXPECT_TRUE(has_line(help, {"--dt", "default 0.1"}));
    EXPECT_TRUE(has_line(help, {"--steps", "default", "else 1000"}));
    for (const char* command : {"list", "run", "snapshot", "record", "view", "hard-cases", "help"})
        EXPECT_TRUE(has_line(run_program({"--help"}).out, {command}));
}

TEST(Help, fits_a_terminal) {
    for (const std::vector<std::string>& words : {std::vector<std::string>{"--help"},
                                                  {"run", "--help"},
                                                  {"snapshot", "--help"},
                                                  {"record", "--help"},
                                                  {"view", "--help"},
                                                  {"list"},
                                                  {"list", "models"},
                                                  {"list", "methods"}}) {
        for (const std::string& line : split(run_program(words).out, '\n')) {
            const auto columns = std::count_if(line.begin(), line.end(), [](char c) { return (c & 0xC0) != 0x80; });
            EXPECT_LE(columns, 100) << line;
            EXPECT_FALSE(line.ends_with(' ')) << '\'' << line << '\'';
        }
    }
}

TEST(Version, is_printed) { EXPECT_THAT(run_program({"--version"}).out, testing::MatchesRegex("steplab [0-9.]+\n")); }

TEST(List, shows_all_models_and_methods) {
    const std::string both = run_program({"list"}).out;
    for (const Model& model : models()) EXPECT_THAT(both, HasSubstr('\n' + std::string(model.info.id) + ' '));
    for (const Method& method : methods()) EXPECT_THAT(both, HasSubstr('\n' + std::string(method.info.id) + ' '));
    EXPECT_LE(split(both, '\n').size(), 60u);
}

void expect_parameters(const Json& list, std::span<const ParameterInfo> parameters) {
    ASSERT_EQ(list.size(), parameters.size());
    for (std::size_t i = 0; i < parameters.size(); ++i) {
        const ParameterInfo& info = parameters[i];
        EXPECT_EQ(list[i].at("name"), info.name);
        EXPECT_EQ(list[i].at("what"), info.what);
        EXPECT_EQ(list[i].at("unit"), info.unit);
        EXPECT_EQ(list[i].at("range"), range_text(info));
        EXPECT_EQ(list[i].at("on_change"), info.on_change == OnChange::restarts ? "restarts" : "applies live");
        if (info.kind == ParameterInfo::Kind::choice) {
            EXPECT_EQ(list[i].at("default"), info.choices[static_cast<std::size_t>(info.default_value)]);
            EXPECT_EQ(list[i].at("choices").size(), info.choices.size());
        } else {
            EXPECT_EQ(list[i].at("default"), info.default_value);
            EXPECT_EQ(list[i].at("minimum").is_null(), !std::isfinite(info.minimum));
            EXPECT_EQ(list[i].at("maximum").is_null(), !std::isfinite(info.maximum));
        }
    }
}

TEST(List, json_agrees_with_the_catalogue) {
    const Json json = Json::parse(run_program({"list", "--json"}).out);
    ASSERT_EQ(json.at("models").size(), models().size());
    ASSERT_EQ(json.at("methods").size(), methods().size());
    for (std::size_t i = 0; i < models().size(); ++i) {
        const Json& entry = json["models"][i];
        EXPECT_EQ(entry.at("id"), models()[i].info.id);
        EXPECT_EQ(entry.at("name"), models()[i].info.name);
        EXPECT_EQ(entry.at("what"), models()[i].info.what);
        EXPECT_EQ(entry.at("opening").at("method"), models()[i].opening.method);
        EXPECT_EQ(entry.at("opening").at("dt"), models()[i].opening.dt);
        expect_parameters(entry.at("parameters"), models()[i].info.parameters);
    }
    for (std::size_t i = 0; i < methods().size(); ++i) {
        const MethodInfo& info = methods()[i].info;
        const Json& entry = json["methods"][i];
        EXPECT_EQ(entry.at("id"), info.id);
        EXPECT_EQ(entry.at("order"), info.order);
        EXPECT_EQ(entry.at("evaluations_per_step"), evaluations_per_step(info, ParameterValues(info.parameters)));
        const double limit = linear_limit(info, ParameterValues(info.parameters));
        EXPECT_EQ(entry.at("linear_limit"), std::isinf(limit) ? Json() : Json(limit));  // null: no limit
        EXPECT_EQ(entry.at("symplectic"), info.symplectic);
        EXPECT_EQ(entry.at("reversible"), info.reversible);
        EXPECT_EQ(entry.at("curiosity"), info.curiosity);
        EXPECT_EQ(entry.at("conserves"), info.conserves);
        EXPECT_EQ(entry.at("source"), info.source);
        expect_parameters(entry.at("parameters"), info.parameters);
    }
    EXPECT_EQ(Json::parse(run_program({"list", "models", "--json"}).out).size(), 1u);
}

TEST(ListScenes, gives_the_title_and_the_lesson_of_each_file) {
    const std::string table = run_program({"list", "scenes"}).out;
    const Json list = Json::parse(run_program({"list", "scenes", "--json"}).out);
    const std::filesystem::path folder = std::filesystem::path(STEPLAB_SOURCE_DIR) / "assets" / "scenes";
    std::size_t files = 0;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        if (entry.path().extension() != ".toml") continue;
        const std::string id = entry.path().stem(), text = text_of(entry.path());
        const auto found = std::find_if(list.begin(), list.end(), [&](const Json& scene) { return scene["id"] == id; });
        ASSERT_NE(found, list.end()) << id;
        const std::string title = (*found)["title"], lesson = (*found)["teaches"];
        EXPECT_THAT(text, HasSubstr("title = \"" + title + '"'));
        EXPECT_THAT(text, HasSubstr(lesson)) << id;
        EXPECT_TRUE(has_line(table, {id + ' ', title})) << id;
        ++files;
    }
    EXPECT_EQ(list.size(), files);
}

}  // namespace
}  // namespace steplab
