#pragma once

#include "lab/study/speed.hpp"

#include <string>

namespace steplab {

/// The measurements of a machine as tables.
std::string bench_text(const MachineSpeed& speed);

/// {"scenes": [{model, method, precision, particles, seconds_per_step, bound}], "instructions": {model, particles,
/// seconds_per_step: {"avx2": ...}}, "threads": {...}}
std::string bench_json(const MachineSpeed& speed);

}  // namespace steplab
