#pragma once

#include "core/shape.hpp"
#include "sim/catalogue.hpp"
#include "sim/run/run_description.hpp"

#include <string>

namespace steplab {

/// How fast initially close trajectories diverge: their distance grows on average as e^(exponent t).
struct LyapunovExponent {
    double exponent = 0;  ///< the largest one, in 1 / unit of time; about 0 where the motion is regular
    double spread = 0;    ///< its standard error, from the variation between intervals of the time
    double growth = 0;    ///< logarithm of the growth of the distance over the whole time

    /// True if the exponent is significantly above 0: above its standard error, and above the value for a regular
    /// motion, whose distance grows linearly in time.
    bool chaotic() const;
};

/// The largest Lyapunov exponent of the scene's motion from its start over this time. The tangent of the motion is
/// integrated exactly (by dual numbers, with the method of the reference) and rescaled after every step (Benettin,
/// Galgani, Giorgilli, Strelcyn, Meccanica 15 (1980) 9); the first quarter, in which the tangent turns into the
/// direction of fastest growth, is left out of exponent and spread. Throws Interrupted.
LyapunovExponent lyapunov_exponent(const Plan& scene, const Shape& shape, double time);

/// Why the state of the described scene cannot be computed at this time, in words with the measured exponent, for use
/// instead of meaningless errors. Empty if the error of its reference is below a thousandth of the scene's spacing, or
/// if trajectories do not diverge exponentially. Throws Interrupted.
std::string chaos_note(const RunDescription& description, double time, double error);

}  // namespace steplab
