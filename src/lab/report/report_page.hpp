#pragma once

#include "lab/study/study.hpp"

#include <span>
#include <string>
#include <vector>

namespace steplab {

/// The report as one self-contained HTML page: diagrams are inline SVG, styles are in its head. `errors`: the
/// accuracies for which it names the fastest run, largest first. Throws Interrupted.
std::string report_page(const std::vector<Study>& studies, std::span<const double> errors, const Circumstances& made);

}  // namespace steplab
