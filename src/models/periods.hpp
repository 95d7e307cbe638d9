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

/// Periodic boundary conditions along an axis: the multiples of a length, in any number type.
template <class N>
class Periods {
public:
    /// 0: no periodic boundary conditions.
    explicit Periods(double length)
        : length_(static_cast<Number>(length)), inverse_(length > 0 ? Number(1) / length_ : Number(0)) {}

    /// The multiple of the length that is nearest to x, |x| being below 10^6 lengths: a constant, without derivatives.
    [[gnu::always_inline]] N nearest(const N& x) const {
        if constexpr (HasLanes<N>) {
            return N(length_) * ((x * N(inverse_) + N(rounding)) - N(rounding));
        } else {
            return N(length_ * ((value_of(x) * inverse_ + rounding) - rounding));
        }
    }

    /// x minus that multiple (minimum image); x itself without periodic boundary conditions.
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

    /// Adding and subtracting it rounds to an integer.
    static constexpr Number rounding = Number(1.5) / std::numeric_limits<Number>::epsilon();

    Number length_, inverse_;
};

/// The position of particle i, or of its image within half a period of the origin.
template <class T>
Vec3 within_period(const Periods<T>& periods, const Field<T>& positions, std::size_t i) {
    const auto within = [&](T x) { return static_cast<double>(periods.within(x)); };
    return {within(positions.x()[i]), within(positions.y()[i]), within(positions.z()[i])};
}

}  // namespace steplab
