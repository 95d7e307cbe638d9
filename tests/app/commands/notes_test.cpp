// What rounding does to runs, as every command that runs something says it.

#include "app/program.hpp"
#include "app/tables.hpp"
#include "io/files.hpp"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace steplab {
namespace {

using Json = nlohmann::json;
using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

using Words = std::vector<std::string>;

Words joined(Words words, const Words& more) {
    words.insert(words.end(), more.begin(), more.end());
    return words;
}

constexpr const char* too_little = "which is too little for bonds of 2 m";

TEST(Notes, of_distances_do_not_depend_on_the_number_of_particles) {
    const auto notes = [](const std::string& particles, const std::string& speed) {
        const Outcome outcome = run_program({"run", "--model", "chain", "--set", "n=" + particles, "--set",
                                             "v0=" + speed, "--precision", "float", "--steps", "20"});
        EXPECT_EQ(outcome.code, 0) << outcome.err;
        return outcome.err;
    };
    for (const char* const particles : {"10", "1001", "100001", "300000"}) {
        EXPECT_THAT(notes(particles, "1e6"), HasSubstr(too_little)) << particles;
        EXPECT_THAT(notes(particles, "2"), IsEmpty()) << particles;
    }
}

TEST(Notes, of_a_scene_file_are_those_of_its_model) {
    const TemporaryFolder folder;
    for (const char* const model : {"chain", "rope", "mesh", "morse", "crystal", "oscillator"}) {
        const std::string file = folder.file(std::string(model) + ".toml");
        ASSERT_EQ(run_program({"export", "--model", model, "--to", "scene", "--out", file}).code, 0);
        const Words how{"--method", "velocity-verlet", "--precision", "float", "--dt", "1e-7", "--steps", "3"};
        const Outcome direct = run_program(joined({"run", "--model", model}, how));
        const Outcome written = run_program(joined({"run", "--scene", file}, how));
        EXPECT_THAT(direct.err, HasSubstr("steplab run: note: a step of dt = 1e-7 s")) << model;
        EXPECT_EQ(written.err, direct.err) << model;
    }
}

TEST(Notes, of_an_ensemble_are_those_of_its_runs_each_said_once) {
    const TemporaryFolder folder;
    const Words all{"run",     "--model", "chain",     "--precision", "float",    "--ensemble",     "5",
                    "--steps", "4",       "--summary", "-",           "--method", "velocity-verlet"};
    for (const Words& more : {Words{}, Words{"--out", folder.file("rows.csv")}}) {
        const Outcome few = run_program(joined(joined(all, {"--spread", "dt=1e-7:0.1"}), more));
        const Json notes = Json::parse(few.out)["notes"];
        ASSERT_EQ(notes.size(), 1u) << few.out;
        EXPECT_THAT(notes[0].get<std::string>(),
                    HasSubstr("1 of 5 runs, the first of them run 0: a step of dt = 1e-7"));
        EXPECT_THAT(few.err, HasSubstr("steplab run: note: 1 of 5 runs, "));
        const Outcome both = run_program(joined(joined(all, {"--spread", "dt=1e-7:1e-6", "--set", "v0=1e12"}), more));
        EXPECT_EQ(Json::parse(both.out)["notes"].size(), 2u) << both.out;
        EXPECT_THAT(both.err, HasSubstr("5 of 5 runs")) << "with increments too small";
        const Outcome none = run_program(joined(joined(all, {"--spread", "dt=0.01:0.1"}), more));
        EXPECT_THAT(Json::parse(none.out)["notes"], IsEmpty());
        EXPECT_THAT(none.err, Not(HasSubstr("note")));
    }
}

TEST(Notes, of_compared_runs_name_the_run) {
    const Outcome outcome =
        run_program({"compare", "--model", "chain", "--until", "1e-5", "--samples", "2", "--run",
                     "method=rk4,dt=1e-6,precision=double", "--run", "method=rk4,dt=1e-6,precision=float"});
    EXPECT_EQ(outcome.code, 0);
    EXPECT_THAT(outcome.err,
                AllOf(HasSubstr("steplab compare: note: run 1: a step of dt = 1e-6 s"), Not(HasSubstr("note: run 0"))));
}

}  // namespace
}  // namespace steplab
