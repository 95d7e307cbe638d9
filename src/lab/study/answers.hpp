#pragma once

#include "lab/study/measurement.hpp"

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace steplab {

/// The fastest of these runs whose error at the end is at most `error`; null if there is none. Diverged runs and runs
/// that were not timed are ignored.
const Measurement* fastest(std::span<const Measurement> runs, double error, std::string_view method = {});

/// The Pareto front: the runs to which no other is superior in both time and error, fastest first.
std::vector<const Measurement*> pareto_front(std::span<const Measurement> runs);

/// "pefrl at dt 0.21 in double, 3.1 times faster than rk4": the fastest run for this error, in words.
std::string answer(std::span<const Measurement> runs, double error);

/// True if the method chooses its steps by a tolerance, false if it takes steps of dt.
bool chooses_its_steps(const RunDescription& run);

/// "dt 0.21" or "tolerance 1e-07".
std::string step_text(const RunDescription& run);

/// The order that a series of one method in one precision shows: the slope of log error against log dt between the two
/// finest runs whose errors are well above the smallest and well below the largest of the series. None if there are no
/// two such runs.
std::optional<double> measured_order(std::span<const Measurement> runs, std::string_view method, Precision precision);

}  // namespace steplab
