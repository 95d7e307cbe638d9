#include "io/lammps/lammps_run.hpp"

#include "core/error.hpp"
#include "core/shown.hpp"
#include "io/lammps/lammps_export.hpp"

#include <fmt/format.h>

#include <cstdlib>
#include <filesystem>
#include <sstream>
#include <unistd.h>
#include <utility>

namespace steplab {

namespace {

/// mpirun takes up to a second to end its ranks.
constexpr double seconds_to_end = 0.2;

bool can_run(const std::string& file) {
    return !std::filesystem::is_directory(file) && access(file.c_str(), X_OK) == 0;
}

/// A file, or a name to be found in PATH.
bool is_program(const std::string& program) {
    if (program.find('/') != std::string::npos) return can_run(program);
    const char* const path = std::getenv("PATH");
    std::istringstream folders(path ? path : "");
    for (std::string folder; std::getline(folders, folder, ':');) {
        if (can_run(folder.append("/").append(program))) return true;
    }
    return false;
}

std::vector<std::string> command(const std::string& folder, std::uint64_t ranks) {
    const std::string line =
        fmt::format("exec sh \"$0/{}\" \"$1\" >\"$0/{}\" 2>&1", lammps_files::script, lammps_files::screen);
    return {"sh", "-c", line, std::filesystem::absolute(folder).string(), fmt::format("{}", ranks)};
}

}  // namespace

void check_lammps_installed(std::uint64_t ranks) {
    const char* const other = std::getenv("LAMMPS");  // as run.sh takes it
    if (other && *other != '\0' && !is_program(other))
        throw FileError(fmt::format("LAMMPS={}: there is no such program", shown(other)));
    if ((!other || *other == '\0') && !is_program("lmp"))
        throw FileError(
            "LAMMPS is not installed: there is no program lmp; on Debian and Ubuntu it is in the package lammps");
    if (ranks > 1 && !is_program("mpirun"))
        throw FileError(
            "there is no program mpirun for several ranks; on Debian and Ubuntu it is in the package openmpi-bin");
}

LammpsRun::LammpsRun(std::string folder, std::uint64_t ranks)
    : output_((check_lammps_installed(ranks), std::move(folder))), program_(command(output_.folder(), ranks)) {}

LammpsRun::~LammpsRun() { program_.ask_to_end(seconds_to_end); }

void LammpsRun::finish() {
    if (program_.end() == ChildProgram::End::done) return;
    throw Error(ExitCode::diverged, fmt::format("LAMMPS ended before the last step: {}", output_.message()));
}

}  // namespace steplab
