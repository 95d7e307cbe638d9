#pragma once

#include "core/vector.hpp"

#include <cstddef>
#include <type_traits>

namespace steplab {

// The same code for vectors and, where all motion is along x, for x components alone. The latter are plain numbers
// rather than vectors with unused components, which compilers would keep in memory.

/// A quantity with 1 or 3 components: a number or a vector.
template <class N, std::size_t Axes>
using Moving = std::conditional_t<Axes == 1, N, Vector<N>>;

template <std::size_t Axes, class N>
[[gnu::always_inline]] inline Moving<N, Axes> moving(const Vector<N>& all) {
    if constexpr (Axes == 1)
        return all.x;
    else
        return all;
}

template <class N>
[[gnu::always_inline]] inline Vector<N> as_vector(const N& along_x) {
    const N zero(0);
    return {along_x, zero, zero};
}
template <class N>
[[gnu::always_inline]] inline const Vector<N>& as_vector(const Vector<N>& all) {
    return all;
}

/// f applied to numbers, or to vectors component by component.
template <class F, class N, class... More>
[[gnu::always_inline]] inline N each_component(F f, const N& number, const More&... more) {
    return f(number, more...);
}
template <class F, class N, class... More>
[[gnu::always_inline]] inline Vector<N> each_component(F f, const Vector<N>& vector, const More&... more) {
    return {f(vector.x, more.x...), f(vector.y, more.y...), f(vector.z, more.z...)};
}

}  // namespace steplab
