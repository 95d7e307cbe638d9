#pragma once

#include "lab/report/figures.hpp"

#include <span>
#include <string>

namespace steplab {

// The tables of a report, as HTML.

/// The fastest way to each error on each scene.
std::string answers_table(std::span<const Study> studies, std::span<const double> errors, const MethodColours& colours);
/// The same for one scene in sentences.
std::string answers_in_words(const Study& study, std::span<const double> errors);
/// The runs that no other beats in both time and error.
std::string pareto_table(const Study& study, const MethodColours& colours);
/// The order that each method's errors show, beside its own, and how many runs there were of it.
std::string orders_table(const Study& study);
/// The stability limits.
std::string limits_table(const Study& study);

}  // namespace steplab
