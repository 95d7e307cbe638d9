#pragma once

#include "io/input_file.hpp"
#include "io/text_input.hpp"
#include "models/scene/starting_values.hpp"

#include <cstdint>
#include <optional>
#include <string>

namespace steplab {

/// "run.trajectory:500": a file, and a step of it.
struct FileAtStep {
    std::string file;
    std::optional<std::uint64_t> step = {};
};
FileAtStep file_at_step(const std::string& text);

/// Positions and velocities of all particles at a step of a trajectory, or of CSV or extended XYZ of any program; at
/// the last one without a step. XYZ without velocities is at rest. Throws FileError.
StartingValues starting_values(InputFile file, std::optional<std::uint64_t> step);
StartingValues starting_values(TextInput text, std::optional<std::uint64_t> step);
/// The same of FILE or FILE:STEP as a command line has it.
StartingValues starting_values(const std::string& file_and_step);

/// As CSV, from which starting_values() gives the same.
std::string csv_text(const StartingValues& values);

}  // namespace steplab
