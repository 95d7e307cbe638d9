#pragma once

#include "plot/plot.hpp"
#include "ui/context.hpp"

#include <functional>
#include <limits>
#include <string>

namespace steplab::ui {

/// A value that a sample does not have: a gap of its curve.
inline constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

using SampleValue = std::function<double(const Sample&)>;

/// A curve over time of what samples hold. Runs that go backward in time ascend, too.
plot::Curve over_time(std::string name, std::size_t colour, const SampleSeries& series, const SampleValue& value);

/// The name of a run of the session in a legend.
std::string name_of_run(const Context& context, std::size_t run);

/// The same of all runs, each in its colour and line.
void add_runs(plot::Plot& plot, const Context& context, const SampleValue& value);

}  // namespace steplab::ui
