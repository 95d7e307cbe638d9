#include "app/program.hpp"
#include "sim/catalogue.hpp"
#include "support/runs.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace steplab {
namespace {

using Json = nlohmann::json;

std::string text(const Json& value) { return value.is_string() ? value.get<std::string>() : value.dump(); }

/// The command line that a summary describes.
std::vector<std::string> words_of(const Json& summary) {
    std::vector<std::string> words{"run", "--summary", "-"};
    for (const char* name : {"model", "method", "precision", "dt", "steps"})
        words.insert(words.end(), {std::string("--") + name, text(summary.at(name))});
    for (const auto& [name, value] : summary.at("parameters").items())
        words.insert(words.end(), {"--set", name + "=" + text(value)});
    return words;
}

class SummaryOf : public testing::TestWithParam<test::MethodCase> {};

TEST_P(SummaryOf, each_run_is_enough_to_repeat_it) {
    for (const Model* const model : test::models_for(GetParam().info->id, GetParam().precision)) {
        std::vector<std::string> words{"run",
                                       "--summary",
                                       "-",
                                       "--model",
                                       std::string(model->info.id),
                                       "--method",
                                       GetParam().id(),
                                       "--precision",
                                       std::string(id(GetParam().precision)),
                                       "--dt",
                                       "0.013",
                                       "--steps",
                                       "3"};
        if (model->info.id == "mesh") words.insert(words.end(), {"--set", "kick=corner"});
        const Json first = Json::parse(run_program(words).out);
        const Json again = Json::parse(run_program(words_of(first)).out);
        EXPECT_EQ(first.at("hash"), again.at("hash")) << model->info.id;
        EXPECT_EQ(first.at("parameters"), again.at("parameters")) << model->info.id;
    }
}

INSTANTIATE_TEST_SUITE_P(Methods, SummaryOf, testing::ValuesIn(test::all_methods()), test::case_name);

}  // namespace
}  // namespace steplab
