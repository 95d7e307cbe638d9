#include "app/commands/commands.hpp"
#include "app/program.hpp"
#include "app/tables.hpp"
#include "core/interruption.hpp"
#include "lab/hard_cases/hard_case.hpp"
#include "sim/catalogue.hpp"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <string>
#include <thread>
#include <unistd.h>

namespace steplab {
namespace {

using Json = nlohmann::json;
using testing::HasSubstr;

constexpr const char* cheap = "drag";  // no runs, only matrices of one step

TEST(HardCases, are_listed_with_their_titles) {
    const Outcome outcome = run_program({"hard-cases"});
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    const std::vector<std::string> lines = split(outcome.out, '\n');
    ASSERT_EQ(lines.size(), hard_cases().size() + 1);
    for (std::size_t i = 0; i < hard_cases().size(); ++i) {
        EXPECT_THAT(lines[i + 1], testing::StartsWith(std::string(hard_cases()[i].id) + ' '));
        EXPECT_THAT(lines[i + 1], testing::EndsWith(' ' + std::string(hard_cases()[i].title)));
    }
}

TEST(HardCases, are_listed_as_json) {
    const Json list = Json::parse(run_program({"hard-cases", "--json"}).out);
    ASSERT_EQ(list.size(), hard_cases().size());
    for (std::size_t i = 0; i < list.size(); ++i) {
        EXPECT_EQ(list[i].at("id"), hard_cases()[i].id);
        EXPECT_EQ(list[i].at("title"), hard_cases()[i].title);
        EXPECT_EQ(list[i].at("shows"), hard_cases()[i].shows);
    }
}

TEST(HardCases, one_is_run_and_has_a_row_for_each_method) {
    const HardCase expected = hard_case(cheap);
    const Outcome outcome = run_program({"hard-cases", cheap});
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_THAT(outcome.out, testing::StartsWith(std::string(expected.title) + "\n\n"));
    EXPECT_THAT(outcome.out, HasSubstr("\nmethod "));
    for (const auto& row : expected.table().rows) {
        std::string text = "\n";
        text += row.front().substr(1, row.front().size() - 2);  // without the backticks of Markdown
        EXPECT_THAT(outcome.out, HasSubstr(text + ' '));
        EXPECT_THAT(outcome.out, HasSubstr(row.back()));
    }
    for (const std::string& line : split(outcome.out, '\n')) {
        const auto columns = std::count_if(line.begin(), line.end(), [](char c) { return (c & 0xC0) != 0x80; });
        EXPECT_LE(columns, 100) << line;
    }
}

TEST(HardCases, one_is_run_as_json) {
    const HardCase expected = hard_case(cheap);
    const Table table = expected.table();
    const Json json = Json::parse(run_program({"hard-cases", cheap, "--json"}).out);
    EXPECT_EQ(json.at("id"), cheap);
    EXPECT_EQ(json.at("title"), expected.title);
    EXPECT_EQ(json.at("columns"), Json(table.head));
    ASSERT_EQ(json.at("rows").size(), methods().size());
    for (std::size_t i = 0; i < methods().size(); ++i) {
        EXPECT_EQ(json["rows"][i].at(0), methods()[i].info.id);
        EXPECT_EQ(json["rows"][i].at(1), table.rows[i].at(1));
    }
}

TEST(HardCases, unknown_one_is_refused_with_the_nearest) {
    const Outcome outcome = run_program({"hard-cases", "caos"});
    EXPECT_EQ(outcome.code, 2);
    EXPECT_EQ(outcome.out, "");
    for (const char* word : {"unknown hard case 'caos'", "did you mean 'chaos'", "marginal-dt"})
        EXPECT_THAT(outcome.err, HasSubstr(word));
}

// In a process of its own, in which a signal arrives while methods are running.
class HardCasesDeathTest : public testing::TestWithParam<const char*> {
protected:
    [[noreturn]] static void run_and_interrupt() {
        using Clock = std::chrono::steady_clock;
        catch_interruptions();
        Clock::time_point sent;
        std::thread signal([&sent] {
            std::this_thread::sleep_for(std::chrono::milliseconds(200));
            sent = Clock::now();
            kill(getpid(), SIGINT);
        });
        const int code = run_steplab({"hard-cases", GetParam()});
        const auto end = Clock::now();
        signal.join();
        std::_Exit(end - sent < std::chrono::seconds(1) ? code : 1);
    }
};

TEST_P(HardCasesDeathTest, ends_within_a_second_of_an_interruption) {
    EXPECT_EXIT(run_and_interrupt(), testing::ExitedWithCode(128 + SIGINT), "");
}

INSTANTIATE_TEST_SUITE_P(Names, HardCasesDeathTest, testing::Values("folding", "stiff-rope", "chaos", "marginal-dt"),
                         [](const auto& test) {
                             std::string name = test.param;
                             std::replace(name.begin(), name.end(), '-', '_');
                             return name;
                         });

}  // namespace
}  // namespace steplab
