#pragma once

#include <string>

namespace steplab {

// The catalogue as text for a terminal: aligned, at most 100 columns wide. All of it comes from the entries.

/// Where the catalogue is shown: the end of every command's help.
std::string catalogue_hint();
/// The models, or the methods, and all their parameters with unit, default and range.
std::string models_with_parameters();
std::string methods_with_parameters();
/// A short table of the models.
std::string models_table();
/// A short table of the methods.
std::string methods_table();

/// All data of the entries as JSON: {"models": [...], "methods": [...]}, or one of the two lists alone.
std::string catalogue_json(bool with_models, bool with_methods);

}  // namespace steplab
