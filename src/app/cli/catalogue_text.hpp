#pragma once

#include <string>

namespace steplab {

/// The catalogue for a person at a terminal. Aligned, at most 100 columns wide; everything comes from the entries.

/// Models, methods and all their parameters with unit, default and range: the foot of every command's help.
std::string catalogue_help();
/// One short table each: what there is to choose from.
std::string models_table();
std::string methods_table();

/// Everything the entries know: {"models": [...], "methods": [...]}, or one of the two lists alone.
std::string catalogue_json(bool with_models, bool with_methods);

}  // namespace steplab
