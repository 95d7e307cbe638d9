#pragma once

#include "lab/report/figure.hpp"

#include <string>
#include <utility>
#include <vector>

namespace steplab {

/// A mark on an axis and what is written beside it.
struct Tick {
    double value;
    std::string text;  ///< empty: only a small mark
};

/// The decades of a logarithmic axis from `low` to `high`: each has a mark, and as many a text as can stand beside each
/// other, in the words of the quantity.
std::vector<Tick> decades(std::pair<double, double> range, Quantity quantity);

}  // namespace steplab
