#pragma once

#include "lab/study/measurement.hpp"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace steplab {

/// "model,method,precision,dt,steps,evaluations,wall_s,error,energy_error,status,hash,rms_error,tolerance,settings"
extern const char* const speed_error_header;

/// One line for each measurement, below the header: numbers in the shortest form that reads back exactly. Cells without
/// a value in a diverged run are empty; tolerance is empty for methods with fixed steps; settings are the parameters
/// that differ from their defaults, "L=3 v0=1".
std::string speed_error_csv(std::span<const Measurement> measurements);

/// Reads those of a scene back; those numbers of a result that are not among the columns are 0. Throws FileError naming
/// the line that is not of this form.
std::vector<Measurement> parse_speed_error_csv(std::string_view text, const RunDescription& scene);

}  // namespace steplab
