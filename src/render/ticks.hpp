#pragma once

#include <string>
#include <vector>

namespace steplab::render {

/// The smallest of 1, 2, 5 times a power of ten that is at least `value` (> 0).
double round_number_from(double value);

/// Multiples of `step` from `low` to `high`, both included where they are multiples.
std::vector<double> ticks(double low, double high, double step);

/// A tick's number with just the decimals that its step needs: 0.5, 12; on an axis with a `largest` number of six or
/// more figures, or with more than four decimals, 1.2e6.
std::string tick_text(double value, double step, double largest);

}  // namespace steplab::render
