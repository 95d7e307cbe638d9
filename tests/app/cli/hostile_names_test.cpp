// What commands print when they succeed, where every name is one that a terminal would obey.
#include "app/hostile_names.hpp"

#include "app/commands/commands.hpp"
#include "io/files.hpp"

#include <gtest/gtest.h>

#include <set>
#include <string>
#include <vector>

namespace steplab {
namespace {

constexpr const char* scene_text =
    "steplab = 1\n[[particles]]\ngroup = \"pair\"\nline = { count = 2, step = [1, 0, 0] }\nvelocity = [0, 0.1, 0]\n"
    "[[particles]]\nposition = [0, 1, 0]\n[[springs]]\nbetween = \"pair\"\nk = 4\n";

/// One that Slurm can have.
std::string hostile_line(const std::string& ending) {
    std::string name = hostile_name(ending);
    std::erase(name, '\n');
    return name;
}

/// Every command that prints the name of a scene or a file; snapshot, record and view are tested in tests/render.
const std::vector<std::vector<std::string>>& uses() {
    static const std::string scene = hostile_name(".toml"), rows = hostile_name(".trajectory");
    static const std::vector<std::vector<std::string>> all{
        {"list", "scene", "--scene", scene},
        {"run", "--scene", scene, "--steps", "3", "--every", "1", "--out", rows, "--series", hostile_name(".csv"),
         "--summary", hostile_name(".json")},
        {"run", "--scene", scene, "--steps", "3", "--summary", "-"},
        {"run", "--scene", scene, "--steps", "3", "--out", "-"},
        {"run", "--scene", scene, "--steps", "3", "--from", rows, "--reverse"},
        {"run", "--scene", scene, "--steps", "3", "--ensemble", "2", "--spread", "dt=0.1:0.2", "--out",
         hostile_name(".csv")},
        {"convert", rows, "--out", hostile_name(".dump")},
        {"export", "--scene", scene, "--to", "scene", "--out", hostile_name("-2.toml")},
        {"export", "--scene", scene, "--to", "lammps", "--out", hostile_name("-lammps")},
        {"cluster", "--scene", scene, "--ranks", "2", "--submit", "slurm", "--files", hostile_line("-job")},
        {"compare", "--scene", scene, "--run", "method=rk4", "--run", "method=verlet", "--steps", "3", "--out",
         hostile_name("-compared.csv")},
        {"limits", "--scene", scene},
        {"limits", "--scene", scene, "--json"},
        {"hard-cases"},
        {"advise", "--scene", scene, "--until", "1", "--error", "1e-3"},
        {"report", "--quick", "--scene", scene, "--method", "rk4", "--time", "1", "--out", hostile_name("-report")},
    };
    return all;
}

TEST(HostileNames, reach_no_terminal_when_a_command_succeeds) {
    const TemporaryFolder folder;
    put_text(folder.file(hostile_name(".toml")), scene_text);
    for (const std::vector<std::string>& words : uses()) expect_safe_success(words, {.folder = folder.path()});
}

TEST(HostileNames, reach_no_terminal_when_a_file_is_wrong) {
    const TemporaryFolder folder;
    const std::string scene = hostile_name(".toml"), other = hostile_name(".trajectory");
    put_text(folder.file(scene), "particles = \x1b");
    put_text(folder.file(other), "\x1b[2J");
    for (const std::vector<std::string>& words : std::vector<std::vector<std::string>>{
             {"run", "--scene", scene}, {"convert", other}, {"observe", other, "--rdf"}, {"replay", other}}) {
        const Outcome outcome = run_program(words, {.folder = folder.path()});
        EXPECT_EQ(outcome.code, 3) << words[0];
        EXPECT_TRUE(is_safe(outcome.err)) << words[0] << ": " << safe_message(outcome.err);
    }
    const Outcome refused =
        run_program({"cluster", "--steps", "3", "--ranks", "2", "--submit", "slurm", "--files", hostile_name("-job")},
                    {.folder = folder.path()});
    EXPECT_EQ(refused.code, 2);
    EXPECT_TRUE(is_safe(refused.err)) << safe_message(refused.err);
}

TEST(HostileNames, are_tried_with_every_command) {
    std::set<std::string_view> tried{"snapshot", "record", "view"};  // in tests/render
    for (const std::vector<std::string>& words : uses()) tried.insert(words[0]);
    const std::set<std::string_view> without_names{"bench", "crosscheck", "observe", "replay"};
    for (const auto& command : commands({}))
        EXPECT_EQ(tried.count(command->name()) + without_names.count(command->name()), 1u) << command->name();
}

TEST(HostileNames, are_found_where_they_are_printed_as_they_are) {
    EXPECT_FALSE(is_safe("written " + hostile_name(".csv")));
    EXPECT_FALSE(is_safe("written \xc2\x9b"));
    EXPECT_FALSE(is_safe("a\n~own line"));
    EXPECT_TRUE(is_safe("written " + shown(hostile_name(".csv")) + "\n"));
}

}  // namespace
}  // namespace steplab
