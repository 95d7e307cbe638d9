#pragma once

#include <cmath>

namespace steplab {

/// g(t) with g'' + gamma g' + omega2 g = 0, g(0) = 0, g'(0) = 1: how a mode answers a kick at any damping.
/// omega2 = 0 is free motion with drag.
inline double kick_response(double omega2, double gamma, double t) {
    const double half = gamma / 2;
    const double discriminant = omega2 - half * half;
    const double rate = std::sqrt(std::abs(discriminant));
    const double phase = rate * t;
    if (phase < 1e-8) return t * std::exp(-half * t);  // sin(x)/x and sinh(x)/x are 1 within x^2/6
    if (discriminant > 0) return std::exp(-half * t) * std::sin(phase) / rate;
    // e^(-half t) sinh(rate t) / rate without the overflow of sinh; expm1 keeps the digits of slow decay
    const double slow = omega2 > 0 ? -omega2 / (half + rate) : 0;
    return std::exp(slow * t) * -std::expm1(-2 * phase) / (2 * rate);
}

}  // namespace steplab
