#include "io/lammps/lammps_run.hpp"

#include "core/error.hpp"
#include "core/number_text.hpp"
#include "core/shown.hpp"
#include "io/lammps/lammps_export.hpp"
#include "io/text_input.hpp"

#include <fmt/format.h>

#include <array>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <unistd.h>
#include <utility>

namespace steplab {

namespace {

/// What LAMMPS prints.
constexpr const char* screen_file = "screen.lammps";
/// mpirun takes up to a second to end its ranks.
constexpr double seconds_to_end = 0.2;

bool is_installed(const std::string& program) {
    const char* const path = std::getenv("PATH");
    std::istringstream folders(path ? path : "");
    for (std::string folder; std::getline(folders, folder, ':');) {
        if (access(folder.append("/").append(program).c_str(), X_OK) == 0) return true;
    }
    return false;
}

/// What lies behind an error of LAMMPS, where a scene of steplab can cause it.
std::string_view cause_of(std::string_view error) {
    constexpr std::array<std::array<std::string_view, 2>, 5> causes{{
        {"Bond atoms", ": a spring is more than three times as long as at the start; is dt too large?"},
        {"Lost atoms", ": particles move too far in a step; is dt too large?"},
        {"Non-numeric", ": is dt too large?"},
        {"table inner cutoff", ": two particles came closer than the table of their force reaches"},
        {"Fix halt", ": two particles are farther apart than the cut-off that a force without one has there"},
    }};
    for (const auto& [text, cause] : causes) {
        if (error.find(text) != std::string_view::npos) return cause;
    }
    return "";
}

std::vector<std::string> command(const std::string& folder, std::uint64_t ranks) {
    const std::string line = fmt::format("exec sh \"$0/{}\" \"$1\" >\"$0/{}\" 2>&1", lammps_files::script, screen_file);
    return {"sh", "-c", line, std::filesystem::absolute(folder).string(), fmt::format("{}", ranks)};
}

/// The end of a file, some thousand bytes of it; empty if there is none.
std::string tail_of(const std::string& name) {
    std::ifstream file(name, std::ios::binary);
    file.seekg(0, std::ios::end);
    constexpr std::streamoff most = 4000;
    const std::streamoff size = file ? std::streamoff(file.tellg()) : 0;
    file.seekg(size > most ? size - most : 0);
    return {std::istreambuf_iterator<char>(file), {}};
}

/// An energy; of one that is written "nan" or "-inf" no number.
std::optional<double> energy_of(const std::string& word) {
    if (word.find("nan") != std::string::npos || word.find("inf") != std::string::npos) return NAN;
    return parse_number(word);
}

/// "     100 0.5 1.25 0" as numbers.
std::optional<LammpsEnergy> energy_in(const std::string& line) {
    std::istringstream words(line);
    std::string step, potential, kinetic, outside, more;
    if (!(words >> step >> potential >> kinetic >> outside) || words >> more) return std::nullopt;
    const auto number = parse_number(step), v = energy_of(potential), t = energy_of(kinetic), w = energy_of(outside);
    if (!number || !v || !t || !w || *number < 0) return std::nullopt;
    return LammpsEnergy{static_cast<std::uint64_t>(*number), *v, *t, *w};
}

}  // namespace

void check_lammps_installed(std::uint64_t ranks) {
    if (!is_installed("lmp"))
        throw FileError(
            "LAMMPS is not installed: there is no program lmp; on Debian and Ubuntu it is in the package lammps");
    if (ranks > 1 && !is_installed("mpirun"))
        throw FileError(
            "there is no program mpirun for several ranks; on Debian and Ubuntu it is in the package openmpi-bin");
}

LammpsRun::LammpsRun(std::string folder, std::uint64_t ranks)
    : folder_((check_lammps_installed(ranks), std::move(folder))), program_(command(folder_, ranks)) {}

LammpsRun::~LammpsRun() { program_.ask_to_end(seconds_to_end); }

std::optional<std::uint64_t> LammpsRun::step() const {
    std::istringstream lines(tail_of(folder_ + '/' + lammps_files::log));
    std::optional<std::uint64_t> last;
    for (std::string line; std::getline(lines, line) && !lines.eof();) {
        if (const auto energy = energy_in(line)) last = energy->step;
    }
    return last;
}

/// What LAMMPS says itself: its line of an error, else the last it printed.
std::string LammpsRun::message() const {
    std::istringstream lines(tail_of(folder_ + '/' + screen_file));
    std::string last, error;
    for (std::string line; std::getline(lines, line);) {
        if (line.starts_with("ERROR") && error.empty()) error = line;
        if (!line.empty()) last = line;
    }
    return safe_message(error.empty() ? last : error);
}

void LammpsRun::finish() {
    if (program_.end() == ChildProgram::End::done) return;
    const std::string said = message();
    throw Error(ExitCode::diverged, fmt::format("LAMMPS ended before the last step: {}{}", said, cause_of(said)));
}

std::vector<LammpsEnergy> LammpsRun::energies() const {
    std::vector<LammpsEnergy> all;
    TextInput log(InputFile(folder_ + '/' + lammps_files::log));
    while (const auto line = log.line()) {
        if (const auto energy = energy_in(std::string(*line))) all.push_back(*energy);
    }
    if (all.empty()) log.fail("LAMMPS reported no energies");
    return all;
}

std::string LammpsRun::version() const {
    TextInput log(InputFile(folder_ + '/' + lammps_files::log));
    const auto line = log.line();
    return safe_message(line ? *line : "LAMMPS");
}

}  // namespace steplab
