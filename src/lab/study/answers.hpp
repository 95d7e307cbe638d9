#pragma once

#include "lab/study/measurement.hpp"

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace steplab {

/// The fastest of these runs whose error at the end is at most `error`; null if none reaches it. Diverged runs and runs
/// that were not timed do not count.
const Measurement* fastest(std::span<const Measurement> runs, double error, std::string_view method = {});

/// The runs that no other beats in both time and error, the fastest first.
std::vector<const Measurement*> pareto_front(std::span<const Measurement> runs);

/// "pefrl at dt 0.21 in double, 3.1 times faster than rk4": the answer to who asks for this error.
std::string answer(std::span<const Measurement> runs, double error);

/// "dt 0.21" or "tolerance 1e-07".
std::string step_text(const RunDescription& run);

/// The order that a series of one method in one precision shows: the slope of log error against log dt between the two
/// finest runs whose errors stand clear of the series' least one and of its largest. None if there are no such two.
std::optional<double> measured_order(std::span<const Measurement> runs, std::string_view method, Precision precision);

}  // namespace steplab
