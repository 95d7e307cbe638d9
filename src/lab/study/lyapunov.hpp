#pragma once

#include "core/shape.hpp"
#include "sim/catalogue.hpp"
#include "sim/run/run_description.hpp"

#include <string>

namespace steplab {

/// How fast motions part that begin next to each other: their distance grows as e^(exponent t) in the mean.
struct LyapunovExponent {
    double exponent = 0;  ///< the largest one, in 1 / unit of time; about 0 where the motion is regular
    double spread = 0;    ///< standard error of it, from how it differs between stretches of the time
    double growth = 0;    ///< logarithm of what the distance has grown by over the whole time

    /// True if the exponent stands clear of 0: of its spread, and of what a regular motion's distance, which grows in
    /// proportion to time, gives.
    bool chaotic() const;
};

/// The largest Lyapunov exponent of the scene's motion from its start over this time. Followed is the tangent of the
/// motion, exactly (by dual numbers, in the steps of the reference's method), made small again after every step
/// (Benettin, Galgani, Giorgilli, Strelcyn, Meccanica 15 (1980) 9); its first quarter, in which the tangent turns into
/// the direction that grows most, does not count for exponent and spread. Throws Interrupted.
LyapunovExponent lyapunov_exponent(const Scene& scene, const Shape& shape, double time);

/// Why the described scene cannot be known at this time, in a sentence with the measured exponent, to be shown instead
/// of errors that mean nothing. Empty where its reference's error is below a thousandth of the scene's spacing, or
/// where motions do not part exponentially. Throws Interrupted.
std::string chaos_note(const RunDescription& description, double time, double error);

}  // namespace steplab
