#pragma once

#include "core/field.hpp"
#include "core/lanes.hpp"
#include "core/power.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

namespace steplab {

/// How an adaptive method makes its next step's length from the error of the last one (Hairer, Norsett, Wanner, Solving
/// Ordinary Differential Equations I, II.4, and Gustafsson's memory, beta > 0: Hairer, Wanner II, IV.2).
struct ControlConstants {
    double order = 1;  ///< the error of a step falls with this power of its length
    double beta = 0;
    double safety = 0.9;
    double least = 0.2, most = 10;  ///< factors between a step and the next
};

/// The length of the next step. Errors are in units of the tolerance: a step is good up to 1.
template <class T>
class StepControl {
public:
    explicit StepControl(const ControlConstants& constants) : constants_(constants) {}

    T length() const { return state_.length; }
    void length(T length) { state_ = {length, 1e-4, false}; }

    void accepted(double error) {
        const double memory = constants_.beta > 0 ? power(state_.error_before, constants_.beta) : 1;
        const double factor = constants_.safety * memory / power(error, exponent());
        const double most = state_.rejected ? 1 : constants_.most;
        state_ = {scaled(std::clamp(factor, constants_.least, most)), std::max(error, 1e-4), false};
    }

    /// `tried` may be shorter than length().
    void rejected(double error, T tried) {
        const double factor = std::isfinite(error) ? constants_.safety / power(error, exponent()) : 0;
        state_.length = tried * static_cast<T>(std::clamp(factor, constants_.least, 1.0));
        state_.rejected = true;
    }

    /// Plain data.
    struct State {
        T length = T(0);
        double error_before = 1e-4;
        bool rejected = false;
    };
    const State& state() const { return state_; }
    void state(const State& state) { state_ = state; }

private:
    double exponent() const { return 1 / constants_.order - 0.75 * constants_.beta; }
    T scaled(double factor) const { return state_.length * static_cast<T>(factor); }

    ControlConstants constants_;
    State state_;
};

namespace detail {

/// Folds a field's numbers into a cache line of them, then its lanes from first to last.
template <class T, class F>
T folded(std::span<const T> numbers, F fold) {
    using N = CacheLineLanes<T>;
    N sums(T(0));
    for (std::size_t k = 0; k < numbers.size(); k += N::count) sums = fold(sums, N::load(numbers.data() + k));
    T result = T(0);
    for (std::size_t lane = 0; lane < N::count; ++lane) result = fold(result, sums[lane]);
    return result;
}

}  // namespace detail

template <class T>
T sum_of(const Field<T>& field) {
    return detail::folded<T>(field.flat(), [](auto a, auto b) { return a + b; });
}

/// Of numbers >= 0; not a number if one of them is none.
template <class T>
T largest_of(const Field<T>& field) {
    const T largest = detail::folded<T>(field.flat(), [](auto a, auto b) { return where(a > b, a, b); });
    const T sum = sum_of(field);
    return sum - sum == T(0) ? largest : std::numeric_limits<T>::quiet_NaN();
}

/// The larger of two; not a number if one of them is none.
template <class T>
T larger_of(T a, T b) {
    return b > a || std::isnan(b) ? b : a;
}

}  // namespace steplab
