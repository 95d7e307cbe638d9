#pragma once

#include <span>
#include <vector>

namespace steplab::plot {

/// Amplitudes of the vibrations in a signal.
struct Spectrum {
    std::vector<double> frequencies;  ///< angular, ascending from above 0 to that of two values a period [rad/s]
    std::vector<double> amplitudes;   ///< in the unit of the signal
};

/// Of values at equal distances in time [s], of which there are at least 2. The mean is taken away and a Hann window
/// (Harris, Proceedings of the IEEE 66 (1978) 51) laid over the values, so that a vibration of amplitude A whose
/// frequency does not fit their length is a narrow peak too, of height 0.96 A to A.
Spectrum spectrum(std::span<const double> values, double interval);

}  // namespace steplab::plot
