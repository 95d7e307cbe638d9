#pragma once

#include "lab/report/figure.hpp"

#include <string>
#include <utility>
#include <vector>

namespace steplab {

/// A mark on an axis and its label.
struct Tick {
    double value;
    std::string text;  ///< empty: only a small mark
};

/// The decades of a logarithmic axis over `range`: each has a mark, and as many have a label as there is room for, in
/// the format of the quantity.
std::vector<Tick> decades(std::pair<double, double> range, Quantity quantity);

}  // namespace steplab
