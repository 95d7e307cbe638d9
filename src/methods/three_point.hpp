#pragma once

#include "core/elementwise.hpp"
#include "core/field.hpp"
#include "methods/compensated.hpp"

namespace steplab {

/// The three-point rule x(n+1) = 2 x(n) - x(n-1) + h^2 a(n) kept as position and mean velocity w = (x(n) - x(n-1)) / h
/// of the last interval, so that near-equal positions are never subtracted (increment form, Press et al., Numerical
/// Recipes, 17.4). Drag enters central in time: with f = gamma h / 2,
/// w' = ((1 - f) w + h a) / (1 + f), x' = x + h w'.
template <class T>
struct ThreePoint {
    Field<T> x;    ///< positions
    Field<T> w;    ///< mean velocities over the interval that ends at x; velocities v where a rule starts
    Field<T> a;    ///< accelerations at x
    Lost<T> lost;  ///< of x and w

    ThreePoint() = default;
    ThreePoint(const State<T>& state, bool compensated)
        : x(state.displacement),
          w(state.velocity),
          a(state.displacement.count()),
          lost(compensated, state.displacement.count()) {}

    /// From v at x to the mean velocity over the interval ahead, then along it: w = (1 - f) v + h/2 a, x += h w.
    void first(T h, T drag) {
        if (drag == T(0)) return advance(h, [half = h / T(2)](T, T acc) { return half * acc; });
        advance(h, [f = drag * h / T(2), half = h / T(2)](T v, T acc) { return half * acc - f * v; });
    }

    /// One interval on.
    void next(T h, T drag) {
        if (drag == T(0)) return advance(h, [h](T, T acc) { return h * acc; });
        const T f = drag * h / T(2), slowed = T(2) * f / (T(1) + f), kick = h / (T(1) + f);
        advance(h, [slowed, kick](T mean, T acc) { return kick * acc - slowed * mean; });
    }

    /// The velocity at x from the mean velocity behind it: v = (w + h/2 a) / (1 + f).
    static T velocity(T mean, T acc, T h, T drag) { return (mean + h / T(2) * acc) / (T(1) + drag * h / T(2)); }

    template <class Self, class F>
    static void each_part(Self& self, F f) {
        f(self.x);
        f(self.w);
        f(self.a);
        f(self.lost.x);
        f(self.lost.v);
    }

private:
    template <class Gain>
    void advance(T h, Gain gain) {
        T *const position = x.flat().data(), *const mean = w.flat().data();
        const T* const acceleration = a.flat().data();
        if (lost.kept()) {
            T *const lost_x = lost.x.flat().data(), *const lost_w = lost.v.flat().data();
            return elementwise(x.flat().size(), [=](std::size_t k) {
                add_compensated(mean[k], lost_w[k], gain(mean[k], acceleration[k]));
                add_compensated(position[k], lost_x[k], h * mean[k]);
            });
        }
        elementwise(x.flat().size(), [=](std::size_t k) {
            mean[k] += gain(mean[k], acceleration[k]);
            position[k] += h * mean[k];
        });
    }
};

}  // namespace steplab
