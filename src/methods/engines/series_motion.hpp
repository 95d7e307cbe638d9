#pragma once

#include "core/elementwise.hpp"
#include "core/entry.hpp"
#include "core/field.hpp"
#include "core/lanes.hpp"
#include "core/power.hpp"
#include "core/root.hpp"
#include "methods/engines/counted_drag.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>
#include <vector>

namespace steplab {

// The motion of a scene as power series in time: x[k] is coefficient k of the displacements times unit^k, unit being a
// time near the step's length.

/// 2^n nearest below or at a positive number.
template <class T>
T power_of_two_below(T x) {
    int exponent = 0;
    std::frexp(x, &exponent);
    return std::ldexp(T(1), exponent - 1);
}

/// A unit near `wanted`; halfway between those that were tried where it is beyond them: as far from the right unit
/// coefficients are noise, and the reach that is read from them means little. `too_small` is 0 and `too_large` infinity
/// where none was.
template <class T>
T unit_between(T too_small, T wanted, T too_large) {
    const T unit = power_of_two_below(wanted);
    const bool both = too_small > T(0) && std::isfinite(too_large);
    if (!both || (unit > too_small && unit < too_large)) return unit;
    return power_of_two_below(square_root(too_small) * square_root(too_large));
}

/// Calls f(p, change of x, change of v) for the places p of the first `axes` axes, a register at a time: the sums of
/// the series at time t after their beginning, from the highest order down.
template <class T, class F>
void each_series_sum(std::span<const Field<T>> x, T unit, T t, std::size_t axes, F f) {
    using N = Lanes<T>;
    const T scaled = t / unit;
    const N time(scaled), rate(t / (unit * unit));
    const std::size_t size = x[0].flat().size() / 3 * axes;
    for (std::size_t p = 0; p < size; p += N::count) {
        N of_x(T(0)), of_v(T(0));
        for (std::size_t k = x.size() - 1; k >= 2; --k) {
            const N coefficient = N::load(x[k].flat().data() + p);
            of_x = of_x * time + coefficient;
            of_v = of_v * time + N(static_cast<T>(static_cast<int>(k))) * coefficient;
        }
        f(p, time * (N::load(x[1].flat().data() + p) + time * of_x), rate * of_v);
    }
}

/// Positions, velocities and accelerations at time t of the series, into the fields x, v and a of `then`.
template <class T, class Motion>
void series_motion(std::span<const Field<T>> x, const Field<T>& v, T unit, T t, std::size_t axes, Motion& then) {
    using N = Lanes<T>;
    then.x = x[0];
    then.v = v;
    each_series_sum(x, unit, t, axes,
                    [to_x = then.x.flat().data(), to_v = then.v.flat().data()](std::size_t p, N of_x, N of_v) {
                        (N::load(to_x + p) + of_x).store(to_x + p);
                        (N::load(to_v + p) + of_v).store(to_v + p);
                    });
    const N time(t / unit), rate(T(1) / (unit * unit));
    for (std::size_t p = 0; p < x[0].flat().size() / 3 * axes; p += N::count) {
        N sum(T(0));
        for (std::size_t k = x.size() - 1; k >= 2; --k)
            sum = sum * time + N(static_cast<T>(static_cast<int>(k * (k - 1)))) * N::load(x[k].flat().data() + p);
        (rate * sum).store(then.a.flat().data() + p);
    }
}

/// The last order of a series. -ln(tolerance) / 2 + 1 is best where the cost of a step grows with the square of the
/// order (Jorba, Zou, proposition 3.1). Here most of it grows linearly with the order up to about 25: the best orders,
/// as measured, are higher and nearly the same for all tolerances.
inline std::size_t best_order(double log_tolerance) {
    return static_cast<std::size_t>(std::ceil(14 - log_tolerance / 4));
}

/// Coefficient k + 2 from that of the accelerations without drag: (k + 1) (k + 2) x_(k+2) = a_k - gamma (k + 1)
/// x_(k+1).
template <class T>
void next_order(const Field<T>& acceleration, std::size_t order, T unit, T drag, std::size_t axes,
                std::vector<Field<T>>& x) {
    const auto number = [](std::size_t k) { return static_cast<T>(static_cast<int>(k)); };
    const T scale = T(1) / number((order + 1) * (order + 2));
    const T of_a = unit * unit, of_v = drag * unit * number(order + 1);
    const T *const a = acceleration.flat().data(), *const v = x[order + 1].flat().data();
    T* const next = x[order + 2].flat().data();
    elementwise(acceleration.flat().size() / 3 * axes,
                [=](std::size_t p) { next[p] = (of_a * a[p] - of_v * v[p]) * scale; });
}

/// Displacements at time t of the series.
template <class T>
void series_displacements(std::span<const Field<T>> x, T unit, T t, std::size_t axes, Field<T>& then) {
    using N = Lanes<T>;
    then = x[0];
    each_series_sum(x, unit, t, axes, [to = then.flat().data()](std::size_t p, N change, N) {
        (N::load(to + p) + change).store(to + p);
    });
}

/// The work of drag in the time t from the beginning of the series: of the products of its terms.
template <class T>
double series_work(const CountedDrag& drag, std::span<const Field<T>> x, T unit, T t) {
    const double time = to_double(t) / to_double(unit);
    std::vector<double> rates(x.size() - 1);
    double sum = 0;
    drag.each_place(x[0], [&](std::size_t p, double c) {
        double power = 1;  // v = sum of rates in this unit
        for (std::size_t k = 0; k < rates.size(); ++k, power *= time)
            rates[k] = static_cast<double>(k + 1) * power * to_double(x[k + 1].flat()[p]);
        double squares = 0;
        for (std::size_t i = 0; i < rates.size(); ++i) {
            for (std::size_t j = 0; j < rates.size(); ++j)
                squares += rates[i] * rates[j] / static_cast<double>(i + j + 1);
        }
        sum += c * squares;
    });
    return to_double(t) / (to_double(unit) * to_double(unit)) * sum;
}

/// Where a motion is after a time, by its velocity and acceleration alone.
template <class T, class Motion>
void foresee(const Motion& begin, T ahead, Field<T>& then) {
    const T *const x = begin.x.flat().data(), *const v = begin.v.flat().data(), *const a = begin.a.flat().data();
    T* const to = then.flat().data();
    elementwise(then.flat().size(), [=](std::size_t k) { to[k] = x[k] + ahead * (v[k] + ahead / T(2) * a[k]); });
}

/// The largest component along the first `axes` axes, not a number if one is none.
template <class T>
T largest_component(const Field<T>& field, std::size_t axes) {
    using N = Lanes<T>;
    N most(T(0)), invalid(T(0));
    const T* const components = field.flat().data();
    for (std::size_t p = 0; p < field.flat().size() / 3 * axes; p += N::count) {
        const N component = N::load(components + p);
        const N size = magnitude(component);
        most = where(size > most, size, most);
        invalid = invalid + (component - component);
    }
    T result = T(0);
    for (std::size_t lane = 0; lane < N::count; ++lane) result = std::max(result, most[lane]);
    for (std::size_t lane = 0; lane < N::count; ++lane) result += invalid[lane];
    return result;
}

/// A time in which no term of the series, whose unit of time this is, moves anything by more than rounding; 0 if that
/// is less than `least`. (Near rest velocities alone would allow times in which the further terms, noise as they are,
/// grow.)
template <class T>
T time_of_rounding(std::span<const Field<T>> x, T unit, T least, std::size_t axes) {
    const T rounding = std::numeric_limits<T>::epsilon() * (T(1) + largest_component(x[0], axes));
    T time = std::numeric_limits<T>::infinity();
    for (std::size_t k = 1; k < x.size(); ++k) {
        const T largest = largest_component(x[k], axes);
        if (largest > T(0)) time = std::min(time, unit * root(rounding / largest, static_cast<int>(k)));
        if (!(time > least)) return T(0);
    }
    return std::isfinite(time) ? time : T(0);
}

namespace detail {

/// ln of the time at which a term of this coefficient is 1.
template <class T>
double log_root(T coefficient, double order) {
    const double size = static_cast<double>(coefficient);
    return size > std::numeric_limits<double>::min() ? -logarithm(size) / order : infinity;
}

}  // namespace detail

/// Of a series that ends, in its unit.
template <class T>
inline constexpr T longest_series = T(16);

/// The order up to which a series is known to be good: the last one, unless four coefficients in a row are zero there
/// (near a collision, where rounding makes the high ones, they can be by chance); 2 if all are from there on.
template <class T>
std::size_t last_order(std::span<const Field<T>> x, std::size_t axes) {
    const std::size_t highest = x.size() - 1;
    std::size_t last = highest;
    while (last > 2 && largest_component(x[last], axes) == T(0)) --last;
    return last + 4 > highest ? highest : last;
}

/// How far the series is good, in its unit of time; v are the velocities at its beginning. Its radius of convergence
/// follows from the last coefficients relative to 1 + |x| and 1 + |v|, and the share of it that leaves terms below the
/// tolerance, from the order (Jorba, Zou, Experimental Mathematics 14 (2005) 99, section 3.2). Where forces are so weak
/// that the terms need not fall to be below the tolerance, they must.
template <class T>
T series_reach(std::span<const Field<T>> x, const Field<T>& v, T unit, double log_tolerance, std::size_t axes) {
    const std::size_t last = last_order(x, axes);
    if (last == 2) return longest_series<T>;
    const T of_x = T(1) / (T(1) + largest_component(x[0], axes)),
            of_v = T(1) / (T(1) + largest_component(v, axes)) / unit;
    double log_radius = infinity;
    T high = T(0), low = T(0);
    // no motion in a force ends with t^3: what is behind it was lost to rounding, next to a collision
    for (std::size_t k = std::min(last, std::max<std::size_t>(last, 7) - 3); k <= last; ++k) {
        const T size = largest_component(x[k], axes);
        if (!std::isfinite(size)) return size;
        high = std::max(high, size);
        if (k >= 4) low = std::max(low, largest_component(x[k - 4], axes));
        const auto order = static_cast<double>(k);
        log_radius = std::min({log_radius, detail::log_root(of_x * size, order),
                               detail::log_root(of_v * static_cast<T>(static_cast<int>(k)) * size, order - 1)});
    }
    if (log_radius == infinity) return longest_series<T>;  // nothing but what underflows
    const T share = static_cast<T>(exponential(log_radius + (log_tolerance - 0.7) / static_cast<double>(last)));
    const T falling = T(0.8) * square_root(square_root(low / high));
    return std::min({share, falling > T(0) ? falling : share});
}

}  // namespace steplab
