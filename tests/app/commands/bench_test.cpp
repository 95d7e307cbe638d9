#include "app/commands/bench_text.hpp"
#include "app/program.hpp"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <string>

namespace steplab {
namespace {

using Json = nlohmann::json;
using testing::HasSubstr;

/// As measured on a machine of one instruction set and two processors.
MachineSpeed some_speed() {
    RunDescription chain = describe("chain", "velocity-verlet"), mesh = describe("mesh", "velocity-verlet");
    RunDescription in_float = chain;
    in_float.precision = Precision::float_;
    return {.scenes = {{.run = chain, .particles = 10, .seconds = 2.5e-7, .bound = Bound::latency},
                       {.run = in_float, .particles = 100000, .seconds = 0.0005, .bound = Bound::memory}},
            .instructions = {.run = mesh, .particles = 10000, .seconds = {{"baseline", 0.002}}},
            .threads = {.run = mesh, .particles = 1000000, .seconds = {{"1 thread", 0.5}, {"2 threads", 0.25}}}};
}

TEST(Bench, as_json_is_every_number_as_it_was_measured) {
    EXPECT_EQ(Json::parse(bench_json(some_speed())), Json::parse(R"({
        "scenes": [{"model": "chain", "method": "velocity-verlet", "precision": "double", "particles": 10,
                    "seconds_per_step": 2.5e-7, "bound": "latency"},
                   {"model": "chain", "method": "velocity-verlet", "precision": "float", "particles": 100000,
                    "seconds_per_step": 0.0005, "bound": "memory"}],
        "instructions": {"model": "mesh", "particles": 10000, "seconds_per_step": {"baseline": 0.002}},
        "threads": {"model": "mesh", "particles": 1000000,
                    "seconds_per_step": {"1 thread": 0.5, "2 threads": 0.25}}})"));
}

TEST(Bench, for_a_person_has_units_and_ratios) {
    const std::string text = bench_text(some_speed());
    for (const char* line : {"velocity-verlet on one thread", "chain +10 +double +250 ns +25 ns +4 million +latency",
                             "chain +100.*000 +float +500 µs +5 ns +2 thousand +memory", "baseline +2 ms +1.00",
                             "2 threads +250 ms +2.00"})
        EXPECT_THAT(text, testing::ContainsRegex(line));
}

TEST(Bench, refuses_an_unknown_method) {
    const Outcome outcome = run_program({"bench", "--method", "rk5"});
    EXPECT_EQ(outcome.code, 2);
    EXPECT_THAT(outcome.err, HasSubstr("unknown method 'rk5'"));
    EXPECT_THAT(outcome.err, HasSubstr("did you mean 'rk4'"));
}

}  // namespace
}  // namespace steplab
