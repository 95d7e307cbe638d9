#pragma once

#include <cmath>

namespace steplab {

/// The response of a mode to a kick, with any damping: g with g'' + gamma g' + omega2 g = 0, g(0) = 0, g'(0) = 1.
/// omega2 = 0 is free motion with drag. In long double, so that its phase is accurate to the last bit of a double for a
/// long time.
struct KickResponse {
    long double g = 0;       ///< g(t)
    long double g_rate = 1;  ///< g'(t)

    KickResponse(long double omega2, long double gamma, long double t) {
        const long double half = gamma / 2;
        const long double discriminant = omega2 - half * half;
        const long double rate = std::sqrt(std::abs(discriminant));
        const long double phase = rate * t;
        if (phase < 1e-9L) {  // sin(x)/x and sinh(x)/x are 1 within x^2/6
            critical(half, t);
        } else if (discriminant > 0) {
            weak(half, rate, t);
        } else {
            strong(omega2 > 0 ? -omega2 / (half + rate) : 0, rate, t);
        }
    }

private:
    void critical(long double half, long double t) {
        const long double decay = std::exp(-half * t);
        g = t * decay;
        g_rate = decay * (1 - half * t);
    }
    void weak(long double half, long double rate, long double t) {
        const long double decay = std::exp(-half * t);
        g = decay * std::sin(rate * t) / rate;
        g_rate = decay * std::cos(rate * t) - half * g;
    }
    /// e^(-half t) sinh(rate t) / rate without overflow of sinh; expm1 avoids cancellation for slow decay.
    void strong(long double slow, long double rate, long double t) {
        g = std::exp(slow * t) * -std::expm1(-2 * rate * t) / (2 * rate);
        g_rate = slow * g + std::exp((slow - 2 * rate) * t);
    }
};

/// Upper bound of the rounding error of v0 g(t), mainly from its phase omega t.
inline double mode_rounding(long double v0, long double omega, double t) {
    const long double size = std::abs(v0) * (omega * t > 1 ? 1 / omega : t);
    return static_cast<double>(size * 2e-19L * (4 + omega * t));
}

inline double kick_response(double omega2, double gamma, double t) {
    return static_cast<double>(KickResponse(omega2, gamma, t).g);
}

}  // namespace steplab
