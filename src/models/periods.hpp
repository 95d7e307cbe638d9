#pragma once

#include "core/number.hpp"
#include "core/stages.hpp"

#include <type_traits>
#include <utility>

namespace steplab {

/// Whole periods of a space that repeats itself: a length and its multiples, in any number type.
template <class N>
class Periods {
public:
    explicit Periods(double length) : length_(static_cast<Number>(length)), inverse_(Number(1) / length_) {}

    /// The multiple of the length that is nearest to a number below 10^6 lengths: a constant, where it has derivatives.
    [[gnu::always_inline]] N nearest(const N& x) const {
        if constexpr (SideBySide<N>) {
            return N(length_) * ((x * N(inverse_) + N(rounding)) - N(rounding));
        } else {
            return N(length_ * ((value_of(x) * inverse_ + rounding) - rounding));
        }
    }

private:
    template <class Any>
    struct NumberOf {
        using Type = std::remove_cvref_t<decltype(value_of(std::declval<Any>()))>;
    };
    template <SideBySide Any>
    struct NumberOf<Any> {
        using Type = std::remove_cvref_t<decltype(std::declval<Any>()[0])>;
    };
    using Number = typename NumberOf<N>::Type;

    /// Adding and subtracting it rounds to a whole number.
    static constexpr Number rounding = [] {
        if constexpr (std::is_same_v<Number, long double>) {
            return 0x1.8p63L;
        } else {
            return detail::ExponentialTraits<Number>::shift;
        }
    }();

    Number length_, inverse_;
};

}  // namespace steplab
