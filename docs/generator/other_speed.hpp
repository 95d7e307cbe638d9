#pragma once

#include "results.hpp"

#include <string>

namespace steplab::docs {

/// The wall time of whole runs to a given error, of steplab and of the fastest library, with the goal; empty if none
/// was measured.
std::string error_section(const Results& results);

/// Rendering, the cost of a window's views, file output and processes, with the goals; empty if none was measured.
std::string others_section(const Results& results);

}  // namespace steplab::docs
