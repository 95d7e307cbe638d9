#include "app/program.hpp"
#include "app/tables.hpp"
#include "sim/catalogue.hpp"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <cmath>

namespace steplab {
namespace {

using Json = nlohmann::json;
using testing::HasSubstr;

Json limits(std::vector<std::string> options) {
    std::vector<std::string> words{"limits", "--json"};
    words.insert(words.end(), options.begin(), options.end());
    const Outcome outcome = run_program(words);
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(without_progress(outcome.err), "");
    return Json::parse(outcome.out);
}

TEST(Limits, are_a_list_with_an_object_for_each_method) {
    const Json list = limits({"--model", "chain", "--set", "n=10", "--method", "all"});
    ASSERT_EQ(list.size(), methods().size());
    for (std::size_t i = 0; i < list.size(); ++i) {
        EXPECT_EQ(list[i].at("method"), methods()[i].info.id);
        EXPECT_EQ(list[i].at("precision"), "double");
        EXPECT_NEAR(list[i].at("omega_max").get<double>(), 1.97272261, 5e-9);  // digits as published
        EXPECT_TRUE(list[i].at("theory").is_number() || list[i].at("theory").is_null());
        EXPECT_TRUE(list[i].contains("measured"));
        EXPECT_TRUE(list[i].at("note").is_string());
    }
}

TEST(Limits, are_zero_where_nothing_is_stable_and_null_where_everything_is) {
    const Json midpoint = limits({"--model", "oscillator", "--method", "midpoint"});
    ASSERT_EQ(midpoint.size(), 1u);
    EXPECT_EQ(midpoint[0].at("theory"), 0);
    EXPECT_EQ(midpoint[0].at("measured"), 0);
    const Json free = limits({"--model", "free", "--method", "rk4", "--precision", "float"});
    EXPECT_TRUE(free[0].at("theory").is_null());
    EXPECT_TRUE(free[0].at("measured").is_null());
    EXPECT_EQ(free[0].at("precision"), "float");
}

TEST(Limits, give_every_method_its_own_settings) {
    const Json list = limits({"--model", "oscillator", "--method", "all", "--set", "substeps=3"});
    for (const Json& limit : list) {
        const double expected = limit.at("method") == "stoermer" ? 6 : 2;
        if (limit.at("method") == "stoermer" || limit.at("method") == "verlet") {
            EXPECT_NEAR(limit.at("theory").get<double>(), expected, 1e-12);
        }
    }
    const Outcome unknown = run_program({"limits", "--model", "oscillator", "--method", "all", "--set", "substep=3"});
    EXPECT_EQ(unknown.code, 2);
    EXPECT_THAT(unknown.err, HasSubstr("'substep'"));
    EXPECT_THAT(unknown.err, HasSubstr("substeps"));
    EXPECT_EQ(run_program({"run", "--method", "all"}).code, 2);  // only here
}

TEST(Limits, are_a_table_within_100_columns) {
    const std::string text = run_program({"limits", "--model", "chain", "--method", "all"}).out;
    EXPECT_THAT(text, HasSubstr("1.97272 1/s"));
    EXPECT_THAT(text, HasSubstr("METHOD"));
    for (const std::string& line : split(text, '\n')) {
        const auto columns = std::count_if(line.begin(), line.end(), [](char c) { return (c & 0xC0) != 0x80; });
        EXPECT_LE(columns, 100) << line;
    }
    for (const Method& method : methods()) EXPECT_THAT(text, HasSubstr('\n' + std::string(method.info.id) + ' '));
}

}  // namespace
}  // namespace steplab
