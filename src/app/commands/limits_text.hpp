#pragma once

#include "lab/limits/limits.hpp"

#include <string>
#include <vector>

namespace steplab {

/// As a text table: a row for each method, `dt` compared with its limit.
std::string limits_table(const std::vector<Limit>& limits, double dt);

/// A JSON list of objects: method, precision, omega_max, theory, measured, note. Time steps; 0 = unstable at any dt,
/// null = no limit (or none found: see the note).
std::string limits_json(const std::vector<Limit>& limits);

}  // namespace steplab
