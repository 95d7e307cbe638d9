#pragma once

#include "core/number.hpp"

namespace steplab {

/// A number with its derivative along one direction: a formula evaluated with it yields its exact directional
/// derivative.
template <class T>
struct Dual {
    T value = T(0);
    T derivative = T(0);

    constexpr Dual() = default;
    constexpr explicit(false) Dual(T number) : value(number) {}
    constexpr Dual(T number, T slope) : value(number), derivative(slope) {}

    friend constexpr Dual operator+(Dual a, Dual b) { return {a.value + b.value, a.derivative + b.derivative}; }
    friend constexpr Dual operator-(Dual a, Dual b) { return {a.value - b.value, a.derivative - b.derivative}; }
    friend constexpr Dual operator-(Dual a) { return {-a.value, -a.derivative}; }
    friend constexpr Dual operator*(Dual a, Dual b) {
        return {a.value * b.value, a.derivative * b.value + a.value * b.derivative};
    }
    friend constexpr Dual operator/(Dual a, Dual b) {
        const T quotient = a.value / b.value;
        return {quotient, (a.derivative - quotient * b.derivative) / b.value};
    }
    Dual& operator+=(Dual b) { return *this = *this + b; }
    Dual& operator-=(Dual b) { return *this = *this - b; }

    friend constexpr bool operator==(Dual a, Dual b) { return a.value == b.value; }
    friend constexpr bool operator<(Dual a, Dual b) { return a.value < b.value; }
    friend constexpr bool operator>(Dual a, Dual b) { return a.value > b.value; }
};

template <class T>
Dual<T> square_root(Dual<T> x) {
    const T root = square_root(x.value);
    return {root, where(root > T(0), x.derivative / (T(2) * where(root > T(0), root, T(1))), T(0))};
}

template <class T>
T value_of(Dual<T> number) {
    return number.value;
}

template <class T>
Dual<T> exponential(Dual<T> x) {
    const T e = exponential(x.value);
    return {e, e * x.derivative};
}

template <class T>
Dual<T> where(bool condition, Dual<T> then, Dual<T> otherwise) {
    return condition ? then : otherwise;
}

}  // namespace steplab
