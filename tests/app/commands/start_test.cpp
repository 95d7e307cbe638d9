#include "app/program.hpp"
#include "io/files.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <filesystem>
#include <string>

namespace steplab {
namespace {

using nlohmann::json;
using testing::HasSubstr;

/// Two masses on a spring along x.
const std::string pair = R"(steplab = 1
title = "Two masses"
[parameters]
k = 3
[[particles]]
group = "a"
[[particles]]
group = "b"
position = [1, 0, 0]
velocity = [0.5, 0, 0]
[[springs]]
pairs = [["a", "b"]]
k = "k"
[run]
method = "velocity-verlet"
dt = 0.01
until = 2
)";

class StartCommands : public testing::Test {
protected:
    void SetUp() override { put_text(scene_, pair); }
    static json summary(std::vector<std::string> arguments) {
        arguments.insert(arguments.end(), {"--summary", "-"});
        const Outcome outcome = run_program(arguments);
        EXPECT_EQ(outcome.code, 0) << outcome.err;
        return json::parse(outcome.out);
    }
    TemporaryFolder folder_;
    const std::string scene_ = folder_.file("pair.toml");
};

TEST_F(StartCommands, runs_a_scene_until_the_end_that_its_file_gives) {
    EXPECT_EQ(summary({"run", "--scene", scene_})["steps"], 200);
    EXPECT_EQ(summary({"run", "--scene", scene_, "--steps", "7"})["steps"], 7);
    EXPECT_EQ(summary({"run", "--scene", scene_, "--until", "0.5"})["steps"], 50);
    EXPECT_EQ(summary({"run", "--scene", scene_, "--dt", "0.1"})["steps"], 20);
}

TEST_F(StartCommands, continues_from_a_file_and_says_so_by_content) {
    const std::string file = folder_.file("half.trajectory");
    const json whole = summary({"run", "--scene", scene_, "--steps", "200"});
    const json half = summary({"run", "--scene", scene_, "--steps", "100", "--every", "50", "--out", file});
    const json second = summary({"run", "--scene", scene_, "--steps", "100", "--from", file});
    EXPECT_EQ(second["energy_end"], whole["energy_end"]);
    EXPECT_THAT(second["start"]["from"]["content"].get<std::string>(), HasSubstr("step,time,particle,x,y,z,vx,vy,vz"));
    EXPECT_EQ(second["scene"]["files"][0]["content"], pair);
    EXPECT_FALSE(whole.contains("start"));
    EXPECT_EQ(summary({"run", "--scene", scene_, "--steps", "0", "--from", file + ":50"})["energy_start"],
              summary({"run", "--scene", scene_, "--steps", "50"})["energy_end"]);
    // the models too, from text as well
    const std::string csv = folder_.file("chain.csv");
    const json chain = summary({"run", "--model", "chain", "--steps", "30", "--out", csv});
    EXPECT_NEAR(summary({"run", "--model", "chain", "--steps", "0", "--from", csv})["energy_end"].get<double>(),
                chain["energy_end"].get<double>(), 1e-14);  // positions in CSV are rounded to some 1e-15
}

TEST_F(StartCommands, goes_there_and_back) {
    const std::string file = folder_.file("there.trajectory");
    const json there = summary({"run", "--scene", scene_, "--out", file});
    const std::vector<std::string> back{"run", "--scene", scene_, "--from", file};
    for (const std::vector<std::string>& turned :
         {std::vector<std::string>{"--reverse"}, {"--dt", "-0.01", "--until", "-2"}}) {
        std::vector<std::string> arguments = back;
        arguments.insert(arguments.end(), turned.begin(), turned.end());
        const json again = summary(arguments);
        EXPECT_NEAR(again["energy_end"].get<double>(), there["energy_start"].get<double>(), 1e-14);  // rounding
        EXPECT_EQ(again["steps"], 200);
    }
    const Outcome signs = run_program({"run", "--scene", scene_, "--dt", "-0.01"});
    EXPECT_EQ(signs.code, 2);
    EXPECT_THAT(signs.err, HasSubstr("differ in sign"));
    EXPECT_EQ(run_program({"advise", "--model", "chain", "--dt", "-0.1", "--error", "1"}).code, 2);
}

TEST_F(StartCommands, refuses_what_cannot_be_a_start) {
    const auto refused = [&](const std::string& from, int code, const char* message) {
        const Outcome outcome = run_program({"run", "--scene", scene_, "--from", from});
        EXPECT_EQ(outcome.code, code);
        EXPECT_THAT(outcome.err, HasSubstr(message));
    };
    refused(folder_.file("none.csv"), 3, "none.csv");
    refused(folder_.file(""), 3, "it is a folder");
    put_text(folder_.file("one.xyz"), "1\n\nX 0 0 0\n");
    refused(folder_.file("one.xyz"), 2, "holds 1 particles, the scene has 2");
    refused(folder_.file("one.xyz:9"), 3, "it has no frame of step 9");
}

// Whatever the scene calls them: all lie in the folder that it is written to, or below it.
TEST_F(StartCommands, writes_the_files_of_other_folders_where_the_scene_finds_them) {
    std::filesystem::create_directories(folder_.file("own/data"));
    put_text(folder_.file("own/data/two.xyz"), "2\n\nX 0 0 0\nX 2 0 0\n");
    const std::string rest = "[[pairs]]\npotential = \"gravity\"\nG = 1\n[run]\ndt = 0.01\nuntil = 0.1\n";
    const std::string scene = folder_.file("own/listed.toml");
    for (const std::string& name : {std::string("data/two.xyz"), std::string("../own/data/two.xyz"),
                                    folder_.file("own/data/two.xyz"), std::string("data/../data/two.xyz")}) {
        put_text(scene, "steplab = 1\n[[particles]]\nfile = \"" + name + "\"\n" + rest);
        const TemporaryFolder other;
        std::filesystem::create_directories(other.file("in"));
        const std::string copy = other.file("in/copy.toml");
        const Outcome outcome = run_program({"export", "--scene", scene, "--to", "scene", "--out", copy});
        ASSERT_EQ(outcome.code, 0) << outcome.err;
        EXPECT_EQ(summary({"run", "--scene", copy})["hash"], summary({"run", "--scene", scene})["hash"]) << name;
        for (const auto& file : std::filesystem::directory_iterator(other.file("")))
            EXPECT_EQ(file.path().filename(), "in");
    }
}

TEST_F(StartCommands, writes_the_files_of_a_scene_beside_it) {
    put_text(folder_.file("start.xyz"), "2\n\nX 0 0 0\nX 2 0 0\n");
    put_text(folder_.file("listed.toml"),
             "steplab = 1\n[[particles]]\nfile = \"start.xyz\"\n[[pairs]]\npotential = "
             "\"gravity\"\nG = 1\n[run]\ndt = 0.01\nuntil = 0.1\n");
    const TemporaryFolder other;
    const std::string scene = folder_.file("listed.toml"), copy = other.file("copy.toml");
    ASSERT_EQ(run_program({"export", "--scene", scene, "--to", "scene", "--out", copy}).code, 0);
    EXPECT_EQ(text_of(other.file("start.xyz")), text_of(folder_.file("start.xyz")));
    EXPECT_EQ(summary({"run", "--scene", copy})["hash"], summary({"run", "--scene", scene})["hash"]);
    EXPECT_EQ(run_program({"export", "--scene", scene, "--to", "scene", "--out", copy}).code, 0) << "the same again";
    put_text(other.file("start.xyz"), "something else");
    const Outcome outcome = run_program({"export", "--scene", scene, "--to", "scene", "--out", copy});
    EXPECT_EQ(outcome.code, 3);
    EXPECT_THAT(outcome.err, HasSubstr("is there with other content"));
}

TEST_F(StartCommands, exports_a_scene_as_the_run_starts_it) {
    const std::string file = folder_.file("half.trajectory"), copy = folder_.file("copy.toml");
    summary({"run", "--scene", scene_, "--steps", "100", "--out", file});
    for (const std::vector<std::string>& start :
         {std::vector<std::string>{"--from", file}, {"--from", file, "--reverse"}, {"--reverse"}}) {
        std::vector<std::string> run{"run", "--scene", scene_}, write{"export", "--scene", scene_};
        write.insert(write.end(), {"--to", "scene", "--out", copy});
        run.insert(run.end(), start.begin(), start.end());
        write.insert(write.end(), start.begin(), start.end());
        ASSERT_EQ(run_program(write).code, 0);
        EXPECT_EQ(summary({"run", "--scene", copy})["hash"], summary(run)["hash"]) << start.front();
    }
    EXPECT_THAT(text_of(copy), HasSubstr("[start]\nreverse = true"));
    ASSERT_EQ(run_program({"export", "--scene", copy, "--reverse", "--to", "scene", "--out", copy}).code, 0);
    EXPECT_THAT(text_of(copy), testing::Not(HasSubstr("reverse"))) << "turned round twice";
}

// Whatever a scene reads, and wherever it is written: nothing that lies there is in the way of the same.
TEST_F(StartCommands, exports_a_scene_that_starts_from_a_file_into_any_folder) {
    for (const char* name : {"half.trajectory", "half.csv", "half.xyz", "half.csv.gz"})
        summary({"run", "--scene", scene_, "--steps", "100", "--every", "50", "--out", folder_.file(name)});
    for (const std::string from : {"half.trajectory", "half.trajectory:50", "half.csv", "half.csv:50", "half.xyz:0",
                                   "half.csv.gz", "half.csv.gz:50"}) {
        SCOPED_TRACE(from);
        const std::string scene = folder_.file("started.toml");
        put_text(scene, pair + "[start]\nfrom = \"" + from + "\"\n");
        const TemporaryFolder empty;
        for (const std::string& copy :
             {folder_.file("copy.toml"), scene, empty.file("copy.toml"), empty.file("copy.toml")}) {
            const json hash = summary({"run", "--scene", scene, "--steps", "9"})["hash"];
            const Outcome outcome = run_program({"export", "--scene", scene, "--to", "scene", "--out", copy});
            ASSERT_EQ(outcome.code, 0) << copy << outcome.err;
            EXPECT_EQ(summary({"run", "--scene", copy, "--steps", "9"})["hash"], hash) << copy;
            EXPECT_EQ(summary({"run", "--scene", scene, "--steps", "9"})["hash"], hash) << "the scene itself";
        }
    }
    const Outcome text = run_program({"export", "--scene", folder_.file("started.toml"), "--to", "scene"});
    EXPECT_THAT(text.out, HasSubstr("from = \"half.csv.gz:50\""));
}

TEST_F(StartCommands, exports_a_run_that_goes_backward) {
    const std::string copy = folder_.file("back.toml");
    const std::vector<std::string> run{"run", "--scene", scene_, "--dt", "-0.02", "--until", "-1"};
    ASSERT_EQ(run_program({"export", "--scene", scene_, "--dt", "-0.02", "--to", "scene", "--out", copy}).code, 0);
    EXPECT_EQ(summary({"run", "--scene", copy, "--until", "-1"})["hash"], summary(run)["hash"]);
    EXPECT_THAT(text_of(copy), testing::Not(HasSubstr("until"))) << "it ends at 2, where such a run does not come";
    for (const char* command : {"limits", "report", "ensemble", "compare"}) {
        const Outcome forward = run_program({command, "--scene", copy});
        EXPECT_EQ(forward.code, 2) << command;
    }
    EXPECT_THAT(run_program({"limits", "--scene", copy}).err, HasSubstr("the scene runs backward in time, dt = -0.02"));
}

TEST_F(StartCommands, exports_a_scene_of_a_compressed_file_into_its_own_folder) {
    const std::string scene = folder_.file("listed.toml"), copy = folder_.file("copy.toml");
    summary({"run", "--scene", scene_, "--steps", "10", "--out", folder_.file("rows.xyz.gz")});
    put_text(scene, "steplab = 1\n[[particles]]\nfile = \"rows.xyz.gz\"\n[[fields]]\ngravity = [0, 1, 0]\n");
    ASSERT_EQ(run_program({"export", "--scene", scene, "--to", "scene", "--out", copy}).code, 0);
    EXPECT_EQ(summary({"run", "--scene", copy, "--steps", "9"})["hash"],
              summary({"run", "--scene", scene, "--steps", "9"})["hash"]);
}

TEST_F(StartCommands, exports_a_model_with_values_of_a_file_beside_it) {
    const std::string file = folder_.file("rope.trajectory"), copy = folder_.file("copy.toml");
    const json half = summary({"run", "--model", "rope", "--steps", "50", "--out", file});
    const std::vector<std::string> from{"--model", "rope", "--from", file};
    std::vector<std::string> run{"run", "--steps", "50"}, write{"export", "--to", "scene"};
    run.insert(run.end(), from.begin(), from.end());
    write.insert(write.end(), from.begin(), from.end());
    const Outcome nowhere = run_program(write);
    EXPECT_EQ(nowhere.code, 2);
    EXPECT_THAT(nowhere.err, HasSubstr("--out FILE"));
    write.insert(write.end(), {"--out", copy});
    ASSERT_EQ(run_program(write).code, 0);
    EXPECT_THAT(text_of(copy), HasSubstr("from = \"copy-start.csv\""));
    EXPECT_EQ(summary({"run", "--scene", copy, "--steps", "50"})["hash"], summary(run)["hash"]);
}

/// The order in which a square cloth of so many particles along a side is stepped.
json order_of_cloth(const std::string& file, int side) {
    put_text(file, fmt::format("steplab = 1\n[[particles]]\ngroup = \"cloth\"\n"
                               "grid = {{ count = [{0}, {0}], steps = [[1, 0, 0], [0, 0, -1]] }}\n"
                               "[[springs]]\nbetween = \"cloth\"\nk = 1\n",
                               side));
    return json::parse(run_program({"list", "scene", "--json", "--scene", file}).out)["order"];
}

TEST_F(StartCommands, list_scene_says_in_which_order_particles_are_stepped) {
    const std::string cloth = folder_.file("cloth.toml");
    EXPECT_EQ(order_of_cloth(cloth, 40), "scene") << "few particles";
    EXPECT_THAT(run_program({"list", "scene", "--scene", cloth}).out, testing::Not(HasSubstr("Z-order")));
    EXPECT_EQ(order_of_cloth(cloth, 60), "z-order");
    EXPECT_THAT(run_program({"list", "scene", "--scene", cloth}).out, HasSubstr("along a Z-order curve"));
}

TEST_F(StartCommands, list_scene_says_what_is_recognised) {
    const auto listed = [](std::vector<std::string> scene) {
        scene.insert(scene.begin(), {"list", "scene", "--json"});
        const Outcome outcome = run_program(scene);
        EXPECT_EQ(outcome.code, 0) << outcome.err;
        return json::parse(outcome.out);
    };
    EXPECT_EQ(listed({"--model", "chain"})["layout"], "line");
    EXPECT_EQ(listed({"--model", "mesh"})["layout"], "grid");
    EXPECT_EQ(listed({"--model", "morse"})["layout"], "pairs");
    EXPECT_EQ(listed({"--model", "crystal"})["layout"], "near-pairs");
    EXPECT_EQ(listed({"--model", "free"})["layout"], "constant");
    const json scene = listed({"--scene", scene_, "--set", "k=7"});
    EXPECT_EQ(scene["layout"], "line") << "whoever wrote it";
    EXPECT_EQ(scene["title"], "Two masses");
    EXPECT_EQ(scene["particles"], 2);
    EXPECT_EQ(scene["springs"], 1);
    EXPECT_EQ(scene["mass"], (json{1.0, 1.0}));
    EXPECT_EQ(scene["parameters"][0]["name"], "k");
    const json pendulums = listed({"--scene", "three-pendulums"});
    EXPECT_EQ(pendulums["layout"], "composed");
    EXPECT_EQ(pendulums["fixed"], 3);
    const json crystal = listed({"--model", "crystal", "--set", "edge=5"});
    EXPECT_EQ(crystal["pair_forces"][0]["pairs"], 125 * 124 / 2);
    EXPECT_THAT(run_program({"list", "scene", "--scene", "figure-eight"}).out, HasSubstr("gravity between 3 pairs"));
}

TEST_F(StartCommands, list_takes_a_scene_for_a_scene_alone) {
    const Outcome outcome = run_program({"list", "models", "--scene", scene_});
    EXPECT_EQ(outcome.code, 2);
    EXPECT_THAT(outcome.err, HasSubstr("list scene"));
}

}  // namespace
}  // namespace steplab
