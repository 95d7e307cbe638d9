#pragma once

#include "lab/hard_cases/hard_case.hpp"

#include <string>

namespace steplab::docs {

/// The models with their parameters and defaults, a row each.
std::string models_table();
/// The methods with what tells them apart, a row each.
std::string methods_table();
/// A heading, a sentence and a table of parameters for each model.
std::string models_in_full();
/// A heading, what it is, what it keeps, its source and parameters for each method.
std::string methods_in_full();

/// A shell command and what it prints, as a code block. `folder` is the programs' folder and comes first in PATH.
/// Throws std::runtime_error if the command fails.
std::string command_and_output(const std::string& command, const std::string& folder);

/// What `steplab COMMAND --help` prints, without the models and methods at its foot.
std::string help_of(const std::string& command, const std::string& folder);

/// The file of a hard case's diagram in docs/images.
std::string picture_name(const HardCase& it);
/// The diagram of a hard case, its caption and its table of every method.
std::string hard_case_in_full(const std::string& id);

/// The section of that name: "models", "methods", "models in full", "methods in full", "thesis table N",
/// "hard case ID", "speed", "keys", "help", "help COMMAND", or "$ any shell command". Throws std::runtime_error if the
/// name is unknown.
std::string section(const std::string& name, const std::string& folder);

}  // namespace steplab::docs
