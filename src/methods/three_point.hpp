#pragma once

#include "core/elementwise.hpp"
#include "core/field.hpp"

namespace steplab {

/// The three-point rule x(n+1) = 2 x(n) - x(n-1) + h^2 a(n) kept as position and mean velocity w = (x(n) - x(n-1)) / h
/// of the last interval, so that near-equal positions are never subtracted (increment form, Press et al., Numerical
/// Recipes, 17.4). Drag enters central in time: with f = gamma h / 2,
/// w' = ((1 - f) w + h a) / (1 + f), x' = x + h w'.
template <class T>
struct ThreePoint {
    Field<T> x;  ///< positions
    Field<T> w;  ///< mean velocities over the interval that ends at x; velocities v where a rule starts
    Field<T> a;  ///< accelerations at x

    /// From v at x to the mean velocity over the interval ahead, then along it: w = (1 - f) v + h/2 a, x += h w.
    void first(T h, T drag) {
        if (drag == T(0)) return advance(h, [half = h / T(2)](T v, T acc) { return v + half * acc; });
        const T kept = T(1) - drag * h / T(2);
        advance(h, [kept, half = h / T(2)](T v, T acc) { return kept * v + half * acc; });
    }

    /// One interval on.
    void next(T h, T drag) {
        if (drag == T(0)) return advance(h, [h](T mean, T acc) { return mean + h * acc; });
        const T f = drag * h / T(2), kept = (T(1) - f) / (T(1) + f), kick = h / (T(1) + f);
        advance(h, [kept, kick](T mean, T acc) { return kept * mean + kick * acc; });
    }

    /// The velocity at x from the mean velocity behind it: v = (w + h/2 a) / (1 + f).
    static T velocity(T mean, T acc, T h, T drag) { return (mean + h / T(2) * acc) / (T(1) + drag * h / T(2)); }

private:
    template <class Mean>
    void advance(T h, Mean mean) {
        T *const position = x.flat().data(), *const mean_velocity = w.flat().data();
        const T* const acceleration = a.flat().data();
        elementwise(x.flat().size(), [=](std::size_t k) {
            mean_velocity[k] = mean(mean_velocity[k], acceleration[k]);
            position[k] += h * mean_velocity[k];
        });
    }
};

}  // namespace steplab
