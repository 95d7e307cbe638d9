// Batch files for Slurm in folders of any name: as sbatch reads its lines, and as a shell reads what is printed.

#include "app/program.hpp"
#include "io/files.hpp"
#include "io/temporary_folder.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

namespace steplab {
namespace {

using testing::AllOf;
using testing::HasSubstr;

Outcome submit(const TemporaryFolder& folder, const std::string& files) {
    return run_program({"cluster", "--model", "mesh", "--method", "velocity-verlet", "--steps", "5", "--ranks", "2",
                        "--submit", "slurm", "--files=" + files},
                       {.folder = folder.path()});
}

/// What follows a word in the first line that has it.
std::string after(const std::string& text, const std::string& word) {
    const std::size_t begin = text.find(word);
    if (begin == std::string::npos) return "no " + word;
    return text.substr(begin + word.size(), text.find('\n', begin) - begin - word.size());
}

/// As sbatch reads one of its lines: in quotation marks of either kind, where a backslash keeps the next character, a
/// blank or # ends nothing. (Slurm 22.05, _get_argument.)
std::string read_by_sbatch(const std::string& line) {
    std::string argument;
    char quote = '\0';
    for (std::size_t i = 0; i < line.size(); ++i) {
        if (line[i] == '\\' && i + 1 < line.size()) {
            argument += line[++i];
        } else if (quote != '\0' ? line[i] == quote : line[i] == '"' || line[i] == '\'') {
            quote = quote != '\0' ? '\0' : line[i];
        } else if (quote == '\0' && (line[i] == ' ' || line[i] == '#')) {
            break;
        } else {
            argument += line[i];
        }
    }
    return argument;
}

/// As the job's output is named: %% is %, any other pattern something of the job; a backslash is left out. (fname.c)
std::string named_by_slurm(const std::string& pattern) {
    std::string name;
    for (std::size_t i = 0; i < pattern.size(); ++i) {
        if (pattern[i] == '\\') return "a name without its patterns";
        if (pattern[i] == '%') name += pattern[++i] == '%' ? "%" : "JOB";
        if (pattern[i] != '%') name += pattern[i];
    }
    return name;
}

/// What a program in the place of another one prints when a shell runs a command in a folder.
std::string printed_by(const TemporaryFolder& folder, const std::string& program, const std::string& script,
                       const std::string& command) {
    std::filesystem::create_directories(folder.file("bin"));
    put_text(folder.file("bin/" + program), "#!/bin/sh\n" + script);
    std::filesystem::permissions(folder.file("bin/" + program), std::filesystem::perms::owner_all);
    put_text(folder.file("command"), command);
    const std::string line = fmt::format("cd '{0}' && PATH='{0}/bin':$PATH bash command >printed", folder.path());
    EXPECT_EQ(std::system(line.c_str()), 0) << command;
    return text_of(folder.file("printed"));
}

TEST(ClusterSubmit, works_in_a_folder_of_any_name) {
    for (const std::string name : {"plain", "job%j", "100%", "%%5t", "two words", "it's", "a \"quoted\" #1", "-n",
                                   "$HOME", "=ls", "tab\there", "\xff"}) {
        SCOPED_TRACE(testing::PrintToString(name));
        const TemporaryFolder folder;
        const Outcome outcome = submit(folder, name);
        ASSERT_EQ(outcome.code, 0) << outcome.err;
        const std::string batch = text_of(folder.file(name + "/job.slurm"));
        EXPECT_EQ(named_by_slurm(read_by_sbatch(after(batch, "#SBATCH --output="))),
                  folder.file(name + "/screen.lammps"));
        EXPECT_EQ(printed_by(folder, "srun", "pwd", batch), folder.file(name) + "\n") << batch;
        const std::string command = "sbatch" + after(outcome.out, "  sbatch");
        EXPECT_EQ(printed_by(folder, "sbatch", "cat \"$1\"", command), batch) << command;
        const std::string run = after(outcome.out, "  run           ");
        EXPECT_EQ(printed_by(folder, "lmp", "pwd", run.substr(0, run.rfind(" RANKS"))), folder.file(name) + "\n")
            << run;
    }
}

TEST(ClusterSubmit, refuses_folders_that_slurm_cannot_name) {
    const TemporaryFolder folder;
    const std::string backslash = "back\\slash", line_break = "line\nbreak";
    for (const std::string& name : {backslash, backslash + "/job", line_break}) {
        const Outcome outcome = submit(folder, name);
        EXPECT_EQ(outcome.code, 2);
        EXPECT_THAT(outcome.err,
                    AllOf(HasSubstr("has a " + std::string(name == line_break ? "line break" : "backslash")),
                          HasSubstr("choose a folder without it")));
        EXPECT_FALSE(std::filesystem::exists(folder.file(name))) << "nothing is written";
    }
    EXPECT_EQ(
        run_program({"export", "--model", "chain", "--to", "lammps", "--out", backslash}, {.folder = folder.path()})
            .code,
        0)
        << "it needs no Slurm";
}

}  // namespace
}  // namespace steplab
