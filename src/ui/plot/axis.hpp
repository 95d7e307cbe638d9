#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace steplab::ui {

/// An axis of a plot: maps values to pixels, linearly or logarithmically.
struct Axis {
    double low = 0;
    double high = 1;
    bool logarithmic = false;
    float from = 0;  ///< pixel of `low`
    float to = 1;    ///< pixel of `high`

    /// Within one length of the axis beyond its ends, also for values that are farther away or not a number.
    float pixel(double value) const;
    double value(float pixel) const;
};

struct Tick {
    double value = 0;
    std::string label;
};

/// Ticks at nice numbers, or at powers of ten on a logarithmic axis, that divide the axis into at most `most` (>= 1)
/// intervals; at both ends of a linear axis that has no nice numbers. None where high > low does not hold.
std::vector<Tick> ticks(const Axis& axis, int most);

/// A point of a plotted line, in pixels.
struct PlotPoint {
    float x = 0;
    float y = 0;
};

/// The line through (x, y), reduced to what its pixels can show: the first, lowest, highest and last point of each
/// column of pixels, so that no peak is lost. `x` is ascending. Points that are not finite, or not positive on a
/// logarithmic axis, are left out.
std::vector<PlotPoint> decimated(std::span<const double> x, std::span<const double> y, const Axis& across,
                                 const Axis& up);

/// Index of the value in `x` (ascending) nearest to `value`; 0 if `x` is empty.
std::size_t nearest(std::span<const double> x, double value);

}  // namespace steplab::ui
