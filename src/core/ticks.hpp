#pragma once

#include <span>
#include <string>
#include <vector>

namespace steplab {

/// Nice numbers and the ticks of axes: one set of rules for the 3D axes, the plots and the report. Numbers that differ
/// by less than a billionth count as equal, because quotients of round numbers are off by rounding.

/// Leading digits of nice numbers: 1, 2 and 5 times powers of ten.
inline constexpr double nice_digits[] = {1, 2, 5};

/// The smallest nice number that is at least `value`. `digits` are the leading digits of another series, ascending from
/// 1 and below 10. A value that is not positive, finite and normal is returned as it is. Infinity beyond the largest
/// double.
double nice_ceil(double value, std::span<const double> digits = nice_digits);
/// The largest nice number that is at most `value`; other values as above.
double nice_floor(double value);
/// The next nice number above and below `value`.
double nice_above(double value);
double nice_below(double value);

/// The step of linear ticks that divides low .. high into at most `intervals` parts; not positive, finite and normal if
/// there is none.
double nice_step(double low, double high, int intervals);

/// The multiples of `step` in low .. high, both ends included. Empty if the range or the step is not finite, if there
/// would be more than 1000, or if the step is below the spacing of doubles there.
std::vector<double> linear_ticks(double low, double high, double step);

/// The exponents of the powers of ten in low .. high, both ends included. Empty unless 0 < low <= high < infinity.
std::vector<int> decades(double low, double high);

/// Position of a value between low < high: 0 at `low`, 1 at `high`, for ends as far apart as doubles are.
double part_between(double low, double high, double value);

struct Range {
    double low = 0;
    double high = 1;
};

/// A range around low .. high that ends at ticks, which divide it into at most `intervals` (>= 2) parts; around a
/// single value if low = high. low .. high itself if no step of double does that; 0 .. 1 if an end is not finite.
Range nice_range(double low, double high, int intervals);

/// The powers of ten around low .. high, at least one decade apart; low and high themselves beyond the last powers of
/// ten that are doubles; 0 .. 1 unless both ends are > 0 and finite.
Range decade_range(double low, double high);

/// The label of a linear tick, with the decimals that the step needs: "0.5", "12". Numbers from 100 000 on an axis up
/// to `largest` and steps of more than four decimals are written as "1.2e6".
std::string tick_text(double value, double step, double largest);

}  // namespace steplab
