#pragma once

#include <string>
#include <vector>

namespace steplab::plot {

/// How values lie along an axis.
enum class Scale {
    linear,
    logarithmic,            ///< of values > 0
    symmetric_logarithmic,  ///< arsinh(value / threshold): logarithmic on both sides of 0, linear around it
};

/// How the powers of ten of a logarithmic axis are written.
enum class Numbers {
    typed,     ///< "1e-7"
    readable,  ///< "10⁻⁷"
    seconds,   ///< "10 µs"
    counts,    ///< "10 000"
};

/// An axis of a plot: maps values to pixels.
struct Axis {
    double low = 0;
    double high = 1;
    Scale scale = Scale::linear;
    float from = 0;        ///< pixel of `low`
    float to = 1;          ///< pixel of `high`
    double threshold = 1;  ///< of a symmetric logarithmic axis: it is about linear up to this distance from 0
    Numbers numbers = Numbers::typed;

    /// True if the axis has a place for the value.
    bool can_show(double value) const;
    /// Within one length of the axis beyond its ends, also for values that are farther away or not a number.
    float pixel(double value) const;
    double value(float pixel) const;
};

struct Tick {
    double value = 0;
    std::string label;
};

/// Ticks at nice numbers, or at powers of ten on a logarithmic axis, that divide the axis into at most `most` (>= 1)
/// intervals; on a symmetric one at 0 and at powers of ten of both signs from the threshold on. At both ends of a
/// linear axis that has no nice numbers. None where high > low does not hold.
std::vector<Tick> ticks(const Axis& axis, int most);

}  // namespace steplab::plot
