#pragma once

#include "results.hpp"

#include <string>

namespace steplab::docs {

/// The time of a whole run to an error, beside the best of the libraries, with the goal; empty if none was measured.
std::string error_section(const Results& results);

/// Pictures, watching, files and processes, with the goals; empty if none were measured.
std::string others_section(const Results& results);

}  // namespace steplab::docs
