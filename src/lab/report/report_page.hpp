#pragma once

#include "lab/study/study.hpp"

#include <span>
#include <string>
#include <vector>

namespace steplab {

/// The report as one page of HTML that needs nothing else: diagrams are inline SVG, styles stand in its head.
/// `errors`: the accuracies it answers for, largest first. Throws FileError if gnuplot cannot be run, Interrupted.
std::string report_page(const std::vector<Study>& studies, std::span<const double> errors, const Circumstances& made);

}  // namespace steplab
