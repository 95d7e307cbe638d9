#pragma once

#include <string>

namespace steplab {

// The catalogue as text for a terminal: aligned, at most 100 columns wide. All of it comes from the entries.

/// Models, methods and all their parameters with unit, default and range: the end of every command's help.
std::string catalogue_help();
/// A short table of the models.
std::string models_table();
/// A short table of the methods.
std::string methods_table();

/// All data of the entries as JSON: {"models": [...], "methods": [...]}, or one of the two lists alone.
std::string catalogue_json(bool with_models, bool with_methods);

}  // namespace steplab
