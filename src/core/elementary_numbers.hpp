#pragma once

#include "core/dual.hpp"
#include "core/elementary.hpp"
#include "core/lanes.hpp"
#include "core/stages.hpp"

#include <cstddef>

namespace steplab {

// The functions of elementary.hpp of dual numbers, and lane by lane: each lane has the bits of a single number.

template <class T>
Dual<T> natural_logarithm(Dual<T> x) {
    return {natural_logarithm(x.value), x.derivative / x.value};
}
template <class T>
Dual<T> sine(Dual<T> x) {
    return {sine(x.value), cosine(x.value) * x.derivative};
}
template <class T>
Dual<T> cosine(Dual<T> x) {
    return {cosine(x.value), -(sine(x.value) * x.derivative)};
}
template <class T>
Dual<T> tangent(Dual<T> x) {
    const T t = tangent(x.value);
    return {t, (T(1) + t * t) * x.derivative};
}
template <class T>
Dual<T> hyperbolic_tangent(Dual<T> x) {
    const T t = hyperbolic_tangent(x.value);
    return {t, (T(1) - t * t) * x.derivative};
}
/// An exponent without derivative adds nothing, where the logarithm has no value either.
template <class T>
Dual<T> general_power(Dual<T> base, Dual<T> exponent) {
    const T value = general_power(base.value, exponent.value);
    T derivative = exponent.value * general_power(base.value, exponent.value - T(1)) * base.derivative;
    if (exponent.derivative != T(0)) derivative += value * natural_logarithm(base.value) * exponent.derivative;
    return {value, derivative};
}

template <HasLanes N>
N natural_logarithm(const N& x) {
    return N::each([&](std::size_t lane) { return natural_logarithm(x[lane]); });
}
template <HasLanes N>
N sine(const N& x) {
    return N::each([&](std::size_t lane) { return sine(x[lane]); });
}
template <HasLanes N>
N cosine(const N& x) {
    return N::each([&](std::size_t lane) { return cosine(x[lane]); });
}
template <HasLanes N>
N tangent(const N& x) {
    return N::each([&](std::size_t lane) { return tangent(x[lane]); });
}
template <HasLanes N>
N hyperbolic_tangent(const N& x) {
    return N::each([&](std::size_t lane) { return hyperbolic_tangent(x[lane]); });
}
template <HasLanes N>
N general_power(const N& base, const N& exponent) {
    return N::each([&](std::size_t lane) { return general_power(base[lane], exponent[lane]); });
}

}  // namespace steplab
