#include "io/lammps/lammps_output.hpp"

#include "core/error.hpp"
#include "core/number_text.hpp"
#include "core/shown.hpp"
#include "io/lammps/lammps_export.hpp"
#include "io/text_input.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string_view>
#include <system_error>

namespace steplab {

namespace {

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

/// "Loop time of 0.25 on 2 procs for 50 steps with 100 atoms".
std::optional<LammpsLoop> loop_in(const std::string& line) {
    if (!line.starts_with("Loop time of ")) return std::nullopt;
    std::istringstream words(line.substr(line.find("of ") + 3));
    std::string seconds, on, ranks;
    words >> seconds >> on >> ranks;
    const auto time = parse_number(seconds), count = parse_number(ranks);
    if (!time || !count || *count < 1) return std::nullopt;
    return LammpsLoop{*time, static_cast<std::uint64_t>(*count)};
}

constexpr std::array result_files{lammps_files::log, lammps_files::trajectory, lammps_files::screen};

TextInput log_of(const LammpsOutput& output) {
    const std::filesystem::path file = std::filesystem::path(output.folder()) / lammps_files::log;
    std::error_code none;
    if (!std::filesystem::exists(file, none))
        throw FileError(fmt::format("no LAMMPS has run in '{}', which has no {}: {}", shown(output.folder()),
                                    lammps_files::log, output.message()));
    return TextInput(InputFile(file.string()));
}

}  // namespace

void refuse_results(const std::string& folder) {
    for (const char* const name : result_files) {
        if (std::filesystem::exists(std::filesystem::path(folder) / name))
            throw FileError(
                fmt::format("'{}' holds the results of an earlier job ({}): choose another folder, or remove "
                            "them",
                            shown(folder), name));
    }
}

void remove_results(const std::string& folder) {
    for (const char* const name : result_files) {
        std::error_code error;
        std::filesystem::remove(std::filesystem::path(folder) / name, error);
        if (error) throw FileError(fmt::format("cannot remove '{}/{}': {}", shown(folder), name, error.message()));
    }
}

std::optional<std::uint64_t> LammpsOutput::step() const {
    std::istringstream lines(tail_of(folder_ + '/' + lammps_files::log));
    std::optional<std::uint64_t> last;
    for (std::string line; std::getline(lines, line) && !lines.eof();) {
        if (const auto energy = energy_in(line)) last = energy->step;
    }
    return last;
}

std::string LammpsOutput::message() const {
    std::istringstream lines(tail_of(folder_ + '/' + lammps_files::screen));
    std::string last, error;
    for (std::string line; std::getline(lines, line);) {
        if (line.starts_with("ERROR") && error.empty()) error = line;
        if (line.find_first_not_of("-=* \t\r") != std::string::npos) last = line;  // not a rule across the page
    }
    const std::string said = error.empty() ? last : error;
    if (said.empty()) return "it printed nothing";
    return safe_message(said).append(cause_of(said));
}

std::vector<LammpsEnergy> LammpsOutput::energies() const {
    std::vector<LammpsEnergy> all;
    TextInput log = log_of(*this);
    while (const auto line = log.line()) {
        if (const auto energy = energy_in(std::string(*line))) all.push_back(*energy);
    }
    if (all.empty()) log.fail("LAMMPS reported no energies");
    return all;
}

std::string LammpsOutput::version() const {
    TextInput log = log_of(*this);
    const auto line = log.line();
    return safe_message(line ? *line : "LAMMPS");
}

std::optional<LammpsLoop> LammpsOutput::loop() const {
    TextInput log = log_of(*this);
    std::optional<LammpsLoop> found;
    while (const auto line = log.line()) {
        if (const auto loop = loop_in(std::string(*line))) found = loop;
    }
    return found;
}

}  // namespace steplab
