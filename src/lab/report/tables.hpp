#pragma once

#include "lab/report/figures.hpp"

#include <span>
#include <string>

namespace steplab {

// The tables of a report, as HTML.

/// The fastest run for each error and scene.
std::string answers_table(std::span<const Study> studies, std::span<const double> errors, const MethodColours& colours);
/// The same for one scene, in words.
std::string answers_in_words(const Study& study, std::span<const double> errors);
/// The Pareto front of time and error.
std::string pareto_table(const Study& study, const MethodColours& colours);
/// The measured order of each method, its theoretical order, and the number of its runs.
std::string orders_table(const Study& study);
/// The stability limits.
std::string limits_table(const Study& study);

}  // namespace steplab
