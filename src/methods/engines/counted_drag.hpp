#pragma once

#include "core/field.hpp"
#include "core/number.hpp"
#include "core/sum.hpp"

#include <cstddef>
#include <utility>
#include <vector>

namespace steplab {

/// What a number of a run is for sums over it.
template <class T>
double to_double(const T& number) {
    return static_cast<double>(value_of(number));
}

/// The work of drag, the integral of the sum of c v^2 over all particles, as a method has it beside its steps: by the
/// weights of its stages, as if the work were one more quantity of the state. In double, from the velocities of the
/// stages as they are; no bit of the state depends on it. Nothing is counted unless coefficients are given.
class CountedDrag {
public:
    CountedDrag() = default;
    /// c of each particle [kg/s].
    explicit CountedDrag(std::vector<double> coefficients) : coefficients_(std::move(coefficients)) {}

    bool on() const { return !coefficients_.empty(); }

    /// Adds the work of a step [J].
    void add(double work) { sum_.add(work); }
    /// Of all that was added.
    const CompensatedSum& sum() const { return sum_; }
    void sum(const CompensatedSum& sum) { sum_ = sum; }

    /// The power that drag takes at these velocities [W].
    template <class T>
    double power(const Field<T>& v) const {
        return power_of(v, [at = v.flat().data()](std::size_t k) { return to_double(at[k]); });
    }
    /// The same of velocities v(k), k being the places in flat() of fields like this one.
    template <class T, class Velocity>
    double power_of(const Field<T>& like, Velocity v) const {
        double sum = 0;
        each_place(like, [&](std::size_t k, double c) {
            const double at = v(k);
            sum += c * at * at;
        });
        return sum;
    }

    /// Calls f(k, c) for every place k in flat() that holds a particle's coordinate.
    template <class T, class F>
    void each_place(const Field<T>& like, F f) const {
        const std::size_t stride = like.flat().size() / 3;
        for (std::size_t begin = 0; begin < 3 * stride; begin += stride) {
            for (std::size_t i = 0; i < like.count(); ++i) f(begin + i, coefficients_[i]);
        }
    }

private:
    std::vector<double> coefficients_;
    CompensatedSum sum_;
};

/// What integrators inherit that count drag, up to the beginning of their last step; and those whose steps end where
/// frames are, up to there.
class CountsDrag {
public:
    CountedDrag& counted_drag() { return drag_; }
    const CountedDrag& counted_drag() const { return drag_; }

protected:
    CountedDrag drag_;
};
class CountsDragAtFrames : public CountsDrag {
public:
    template <class System>
    double drag_work(const System&) const {
        return drag_.sum().value();
    }
};

/// Of velocities v(s) with a constant slope, a motion's, from the time `begin` to `end` after it.
template <class Motion>
double work_at_even_slope(const CountedDrag& drag, const Motion& motion, double begin, double end) {
    const auto power = [&](double s) {
        return drag.power_of(motion.v, [&, v = motion.v.flat().data(), a = motion.a.flat().data()](std::size_t k) {
            return to_double(v[k]) + s * to_double(a[k]);
        });
    };
    // Simpson's rule has squares exactly
    return (end - begin) / 6 * (power(begin) + 4 * power((begin + end) / 2) + power(end));
}

/// Up to a time from the beginning of the step across a collision (within_crossing()).
template <class Before, class After>
double work_in_crossing(const CountedDrag& drag, const Before& before, const After& after, double collision,
                        double time) {
    if (time <= collision) return work_at_even_slope(drag, before, 0, time);
    return work_at_even_slope(drag, before, 0, collision) +
           work_at_even_slope(drag, after, -collision, time - 2 * collision);
}

}  // namespace steplab
