// The studies of every shipped scene, as users ask for them. Few steps and methods keep each to a second or two.

#include "app/program.hpp"
#include "app/tables.hpp"
#include "io/files.hpp"
#include "io/scene_file.hpp"
#include "sim/run/run_description.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <string>
#include <vector>

namespace steplab {
namespace {

using testing::HasSubstr;
using Json = nlohmann::json;

class ShippedScene : public testing::TestWithParam<std::string> {
protected:
    static Outcome studied(std::vector<std::string> words) {
        words.insert(words.begin() + 1, {"--scene", GetParam()});
        Outcome outcome = run_program(words);
        EXPECT_EQ(outcome.code, 0) << outcome.err;
        EXPECT_EQ(without_progress(outcome.err), "");
        return outcome;
    }
};

// Of 20 steps as the scene opens, a method of order 4 loses less than a thousandth of a unit of length.
TEST_P(ShippedScene, is_advised) {
    const std::string text =
        studied({"advise", "--method", "rk4", "--precision", "double", "--steps", "20", "--error", "1e-3"}).out;
    EXPECT_THAT(text, HasSubstr("steplab run --scene " + GetParam() + " --method rk4 "));
    EXPECT_THAT(text, HasSubstr("verified: in a second run its error is "));
}

TEST_P(ShippedScene, has_a_limit_or_the_reason_why_not) {
    const Json list = Json::parse(studied({"limits", "--json", "--method", "velocity-verlet"}).out);
    ASSERT_EQ(list.size(), 1u);
    const Json& limit = list.front();
    EXPECT_EQ(limit.at("method"), "velocity-verlet");
    EXPECT_GE(limit.at("omega_max").get<double>(), 0);
    const bool known = limit.at("theory").is_number() && limit.at("measured").is_number();
    EXPECT_TRUE(known || !limit.at("note").get<std::string>().empty()) << limit;
}

TEST_P(ShippedScene, is_reported) {
    const TemporaryFolder folder;
    const std::string time = fmt::format("{}", 20 * describe(find_scene(GetParam())).dt);
    studied({"report", "--quick", "--method", "rk4", "--method", "velocity-verlet", "--precision", "double", "--time",
             time, "--out", folder.file("out")});
    const CsvTable runs = table(text_of(folder.file("out/speed_error.csv")));
    for (const char* const method : {"rk4", "velocity-verlet"}) {
        EXPECT_TRUE(std::any_of(runs.rows.begin(), runs.rows.end(), [&](const auto& row) {
            return row[0] == GetParam() && row[1] == method && row[9] == "ok";
        })) << method;
    }
    EXPECT_THAT(text_of(folder.file("out/report.html")), HasSubstr(GetParam() + "</h2>"));
}

INSTANTIATE_TEST_SUITE_P(All, ShippedScene, testing::ValuesIn(shipped_scenes()), [](const auto& scene) {
    std::string name = scene.param;
    std::replace(name.begin(), name.end(), '-', '_');
    return name;
});

}  // namespace
}  // namespace steplab
