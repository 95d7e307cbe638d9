#pragma once

#include "core/precision.hpp"
#include "core/vec3.hpp"

#include <optional>
#include <string>
#include <string_view>

namespace steplab::ui {

/// A number and its unit, if it has one: "0.213 J".
std::string with_unit(std::string text, std::string_view unit);
/// "(0, 0.11, 0)": two significant digits; components that are rounding noise of the largest one are 0.
std::string vector(Vec3 value);
/// A time with the decimals that a step of dt can change: "12.300"; from 1e9 on with 9 digits, "1.2e9".
std::string time_text(double time, double dt);
/// A count, in full up to 999 999: "12345"; larger ones with three digits, "1.23e6".
std::string count_text(double count);
/// How often something happens, a count that need not be whole: two digits below 100, from there on as count_text().
std::string frequency_text(double often);
/// An error, with two significant digits also where one is a zero: "0.10", "2.1e-7", "0".
std::string error_text(double error);
/// "1 step", "2 steps".
std::string counted(double count, std::string_view one, std::string_view many);

/// Number of correct decimal digits: -log10(error / scale), at least 0 and at most those of the precision. None if the
/// error is negative or the scale is not positive, or one of them is not finite.
std::optional<double> correct_digits(double error, double scale, Precision precision);

/// "5.3 correct digits so far"; below one: "wrong: not one correct digit".
std::string digits_text(double digits);

/// `value` rounded to three digits (of high - low on a linear slider): less than a pixel of a slider over low .. high.
double rounded_for_slider(double value, double low, double high, bool logarithmic);

}  // namespace steplab::ui
