#include "app/program.hpp"
#include "sim/catalogue.hpp"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <set>
#include <string>

namespace steplab {
namespace {

using Json = nlohmann::json;
using testing::HasSubstr;

// The time of a step depends on the machine: only its sign is tested.
TEST(Bench, measures_every_model_in_both_precisions) {
    const Outcome outcome = run_program({"bench", "--json"});
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    const Json all = Json::parse(outcome.out);
    std::set<std::string> found, expected;
    for (const Json& scene : all.at("scenes")) {
        EXPECT_EQ(scene.at("method"), "velocity-verlet");
        EXPECT_GT(scene.at("particles"), 1);
        EXPECT_GT(scene.at("seconds_per_step"), 0);
        EXPECT_THAT(scene.at("bound"), testing::AnyOf("latency", "arithmetic", "memory"));
        found.insert(scene.at("model").get<std::string>() + " " + scene.at("precision").get<std::string>());
    }
    for (const Model& model : models()) {
        for (const char* precision : {" float", " double"}) expected.insert(std::string(model.info.id) + precision);
    }
    EXPECT_EQ(found, expected);
    EXPECT_GT(all.at("instructions").at("seconds_per_step").at("baseline"), 0);
    EXPECT_GT(all.at("threads").at("seconds_per_step").at("1 thread"), 0);
}

TEST(Bench, refuses_an_unknown_method) {
    const Outcome outcome = run_program({"bench", "--method", "rk5"});
    EXPECT_EQ(outcome.code, 2);
    EXPECT_THAT(outcome.err, HasSubstr("unknown method 'rk5'"));
    EXPECT_THAT(outcome.err, HasSubstr("did you mean 'rk4'"));
}

}  // namespace
}  // namespace steplab
