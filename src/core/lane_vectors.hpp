#pragma once

#include "core/lanes.hpp"

#include <array>
#include <cstddef>
#include <cstring>
#include <utility>

namespace steplab {

// Lanes taken apart. T is float or double.

namespace detail {

/// Numbers in a register of these lanes.
template <class T, std::size_t Count>
inline constexpr std::size_t width_of = sizeof(typename RegisterLanes<T, Count>::Register) / sizeof(T);

template <class T, std::size_t Count, std::size_t First, std::size_t... I>
[[gnu::always_inline]] inline RegisterLanes<T, Count / 2> half(typename RegisterLanes<T, Count>::Register lanes,
                                                               std::index_sequence<I...>) {
    return RegisterLanes<T, Count / 2>(__builtin_shufflevector(lanes, lanes, static_cast<int>(I + First)...));
}

/// x, y, z, z of each lane of the G-th quarter of a register in turn.
template <std::size_t G, class Register, std::size_t... I>
[[gnu::always_inline]] inline Register interleaved(Register x, Register y, Register z, std::index_sequence<I...>) {
    constexpr std::size_t width = sizeof...(I), first = G * (width / 4);
    const Register xy = __builtin_shufflevector(x, y, static_cast<int>(first + I / 4 + (I % 4 == 1 ? width : 0))...);
    return __builtin_shufflevector(xy, z, static_cast<int>(I % 4 < 2 ? I : width + first + I / 4)...);
}

/// Calls f(E, four) for every four numbers of a register.
template <class T, class Register, class F, std::size_t... E>
[[gnu::always_inline]] inline void each_four(Register vectors, F f, std::index_sequence<E...>) {
    constexpr auto at = [](std::size_t place) { return static_cast<int>(place); };
    (f(E, RegisterLanes<T, 4>(
              __builtin_shufflevector(vectors, vectors, at(4 * E), at(4 * E + 1), at(4 * E + 2), at(4 * E + 3)))),
     ...);
}

}  // namespace detail

/// Each lane of the first half plus that lane of the second half.
template <class T, std::size_t Count>
[[gnu::always_inline]] inline RegisterLanes<T, Count / 2> halves_added(const RegisterLanes<T, Count>& lanes) {
    constexpr std::size_t width = detail::width_of<T, Count>, parts = Count / width;
    const auto& registers = lanes.registers();
    if constexpr (parts > 1) {
        alignas(64) std::array<T, Count / 2> sums;
        for (std::size_t p = 0; p < parts / 2; ++p) {
            const auto sum = registers[p] + registers[p + parts / 2];
            std::memcpy(sums.data() + p * width, &sum, sizeof sum);
        }
        return RegisterLanes<T, Count / 2>::load(sums.data());
    } else {
        constexpr std::make_index_sequence<width / 2> places{};
        return detail::half<T, Count, 0>(registers[0], places) +
               detail::half<T, Count, width / 2>(registers[0], places);
    }
}

/// Calls f(lane, four) with the four numbers x[lane], y[lane], z[lane] and one without meaning, for each lane in turn.
template <class T, std::size_t Count, class F>
[[gnu::always_inline]] inline void each_vector(const RegisterLanes<T, Count>& x, const RegisterLanes<T, Count>& y,
                                               const RegisterLanes<T, Count>& z, F f) {
    constexpr std::size_t width = detail::width_of<T, Count>;
    if constexpr (width < 4) {
        for (std::size_t lane = 0; lane < Count; ++lane)
            f(lane, RegisterLanes<T, 4>::each([&](std::size_t c) { return (c == 0 ? x : c == 1 ? y : z)[lane]; }));
    } else {
        for (std::size_t p = 0; p < Count / width; ++p) {
            const auto quarter = [&]<std::size_t G>(std::integral_constant<std::size_t, G>) {
                const auto vectors = detail::interleaved<G>(x.registers()[p], y.registers()[p], z.registers()[p],
                                                            std::make_index_sequence<width>{});
                detail::each_four<T>(
                    vectors, [&](std::size_t e, const auto& four) { f(p * width + G * (width / 4) + e, four); },
                    std::make_index_sequence<width / 4>{});
            };
            quarter(std::integral_constant<std::size_t, 0>{});
            quarter(std::integral_constant<std::size_t, 1>{});
            quarter(std::integral_constant<std::size_t, 2>{});
            quarter(std::integral_constant<std::size_t, 3>{});
        }
    }
}

}  // namespace steplab
