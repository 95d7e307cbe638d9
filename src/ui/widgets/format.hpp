#pragma once

#include "core/vec3.hpp"

#include <optional>
#include <string>
#include <string_view>

namespace steplab::ui {

/// A number and its unit, if it has one: "0.213 J".
std::string with_unit(std::string text, std::string_view unit);
/// Position of a value between low < high: 0 at `low`, 1 at `high`, for ends as far apart as doubles are.
double part_between(double low, double high, double value);
/// "(0, 0.11, 0)": two significant digits; components that are rounding noise of the largest one are 0.
std::string vector(Vec3 value);
/// A time with the decimals that a step of dt can change: "12.300"; from 1e9 on with 9 digits, "1.2e9".
std::string time_text(double time, double dt);
/// "1 step", "2 steps".
std::string counted(double count, std::string_view one, std::string_view many);

/// Number of correct decimal digits: -log10(error / scale), at least 0. None if the error or the scale is not positive
/// and finite.
std::optional<double> correct_digits(double error, double scale);

/// `value` rounded to three digits (of high - low on a linear slider): less than a pixel of a slider over low .. high.
double rounded_for_slider(double value, double low, double high, bool logarithmic);

}  // namespace steplab::ui
