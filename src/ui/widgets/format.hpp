#pragma once

#include "core/vec3.hpp"

#include <optional>
#include <string>
#include <string_view>

namespace steplab::ui {

/// A value that a person sets: up to `digits` significant ones and no zeros behind them: "2.0", "0.25", "1.9e6", "∞".
std::string number(double value, int digits = 4);
/// A value that changes by itself: three significant digits, zeros too, so that it does not jitter: "0.500".
std::string reading(double value);
/// A text with a unit behind it, if there is one: "0.213 J".
std::string with_unit(std::string text, std::string_view unit);
/// An error or a rate in two significant digits: "2.1e-7", "0.31", "0".
std::string scientific(double value);
/// "(0, 0.11, 0)"; parts that are rounding noise of the largest are 0.
std::string vector(Vec3 value);
/// Time with the decimals that a step of dt can change: "12.300".
std::string time_text(double time, double dt);
/// "1 step", "2 steps".
std::string counted(double count, std::string_view one, std::string_view many);

/// Decimal digits that are right: -log10(error / scale), never below 0. None where the error is zero or not finite.
std::optional<double> digits_right(double error, double scale);

/// `value` rounded to a number that is short to write and no further off than a pixel of a slider over low .. high.
double rounded_for_slider(double value, double low, double high, bool logarithmic);

}  // namespace steplab::ui
