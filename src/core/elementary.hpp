#pragma once

#include "core/number.hpp"

#include <cmath>

namespace steplab {

// The functions of expressions besides exponential() and square_root(). In double within 2 ulp over the whole range,
// bit-identical on every system (libm's results differ); a result below the range of normal numbers is subnormal or 0.
// Where a function has no value it is NaN.

inline bool is_whole(double x) { return x == std::rint(x); }

/// ln x; -infinity at 0.
double natural_logarithm(double x);
double sine(double x);
double cosine(double x);
double tangent(double x);
double hyperbolic_tangent(double x);
/// base^exponent; of a negative base for whole exponents alone. x^0 is 1. A result beyond the range of exponential() is
/// 0 or infinite.
double general_power(double base, double exponent);

// Within 1 ulp: those of double, rounded.

inline float natural_logarithm(float x) { return static_cast<float>(natural_logarithm(double(x))); }
inline float sine(float x) { return static_cast<float>(sine(double(x))); }
inline float cosine(float x) { return static_cast<float>(cosine(double(x))); }
inline float tangent(float x) { return static_cast<float>(tangent(double(x))); }
inline float hyperbolic_tangent(float x) { return static_cast<float>(hyperbolic_tangent(double(x))); }
inline float general_power(float base, float exponent) {
    return static_cast<float>(general_power(double(base), double(exponent)));
}

// For reference solutions: libm's.

inline long double natural_logarithm(long double x) { return std::log(x); }
inline long double sine(long double x) { return std::sin(x); }
inline long double cosine(long double x) { return std::cos(x); }
inline long double tangent(long double x) { return std::tan(x); }
inline long double hyperbolic_tangent(long double x) { return std::tanh(x); }
inline long double general_power(long double base, long double exponent) { return std::pow(base, exponent); }

}  // namespace steplab
