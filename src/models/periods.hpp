#pragma once

#include "core/field.hpp"
#include "core/number.hpp"
#include "core/stages.hpp"
#include "core/vec3.hpp"

#include <cstddef>
#include <limits>
#include <type_traits>
#include <utility>

namespace steplab {

/// Whole periods of a space that repeats itself: a length and its multiples, in any number type.
template <class N>
class Periods {
public:
    /// 0: nothing repeats itself.
    explicit Periods(double length)
        : length_(static_cast<Number>(length)), inverse_(length > 0 ? Number(1) / length_ : Number(0)) {}

    /// The multiple of the length that is nearest to a number below 10^6 lengths: a constant, where it has derivatives.
    [[gnu::always_inline]] N nearest(const N& x) const {
        if constexpr (HasLanes<N>) {
            return N(length_) * ((x * N(inverse_) + N(rounding)) - N(rounding));
        } else {
            return N(length_ * ((value_of(x) * inverse_ + rounding) - rounding));
        }
    }

    /// What is left of a number: the number where nothing repeats itself.
    N within(const N& x) const { return length_ > Number(0) ? x - nearest(x) : x; }

private:
    template <class Any>
    struct NumberOf {
        using Type = std::remove_cvref_t<decltype(value_of(std::declval<Any>()))>;
    };
    template <HasLanes Any>
    struct NumberOf<Any> {
        using Type = std::remove_cvref_t<decltype(std::declval<Any>()[0])>;
    };
    using Number = typename NumberOf<N>::Type;

    /// Adding and subtracting it rounds to a whole number.
    static constexpr Number rounding = Number(1.5) / std::numeric_limits<Number>::epsilon();

    Number length_, inverse_;
};

/// Where particle i is, or that of its images which is within half a period of the origin.
template <class T>
Vec3 within_period(const Periods<T>& periods, const Field<T>& positions, std::size_t i) {
    const auto within = [&](T x) { return static_cast<double>(periods.within(x)); };
    return {within(positions.x()[i]), within(positions.y()[i]), within(positions.z()[i])};
}

}  // namespace steplab
