#pragma once

#include "core/lanes.hpp"
#include "core/vector.hpp"

#include <array>
#include <cstddef>
#include <cstring>
#include <type_traits>
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

/// In place I that number of two registers after one another which F names.
template <class Vectors, class F, std::size_t... I>
[[gnu::always_inline]] inline auto picked(Vectors a, Vectors b, F, std::index_sequence<I...>) {
    return __builtin_shufflevector(a, b, static_cast<int>(std::integral_constant<std::size_t, F{}(I)>::value)...);
}

/// Numbers one after another, `Width` of them, each four of which start at address(E), E = First, First + 1, ...
template <class T, std::size_t Width, std::size_t First, class F>
[[gnu::always_inline]] inline auto fours(F address) {
    using Lanes = RegisterLanes<T, Width>;
    if constexpr (Width == 4) {
        return Lanes::load(address(First)).registers()[0];
    } else {
        constexpr auto same = [](std::size_t place) { return place; };
        return picked(fours<T, Width / 2, First>(address), fours<T, Width / 2, First + Width / 8>(address), same,
                      std::make_index_sequence<Width>{});
    }
}

}  // namespace detail

/// Of as many vectors as N has lanes, x, y and z; vector `lane` is three numbers and one without meaning that start at
/// address(lane), aligned as four numbers are.
template <class N, class F>
[[gnu::always_inline]] inline Vector<N> gathered_vectors(F address) {
    using T = std::remove_cvref_t<decltype(*address(0))>;
    constexpr std::size_t width = N::width;
    if constexpr (width < 4) {
        const auto along = [&](std::size_t axis) {
            return N::each([&](std::size_t lane) { return address(lane)[axis]; });
        };
        return {along(0), along(1), along(2)};
    } else {
        std::array<typename N::Register, N::parts> x, y, z;
        constexpr std::make_index_sequence<width> places{};
        // of two registers of vectors: component C of all, then component C + 1
        constexpr auto x_then_y = [](std::size_t i) { return i % (width / 2) * 4 + i / (width / 2); };
        constexpr auto z_then_none = [](std::size_t i) { return i % (width / 2) * 4 + i / (width / 2) + 2; };
        constexpr auto first_halves = [](std::size_t i) { return i + (i < width / 2 ? 0 : width / 2); };
        constexpr auto second_halves = [](std::size_t i) { return i + (i < width / 2 ? width / 2 : width); };
        for (std::size_t p = 0; p < N::parts; ++p) {
            const auto of_part = [&](std::size_t lane) { return address(p * width + lane); };
            const auto a = detail::fours<T, width, 0>(of_part), b = detail::fours<T, width, width / 4>(of_part),
                       c = detail::fours<T, width, width / 2>(of_part),
                       d = detail::fours<T, width, 3 * width / 4>(of_part);
            const auto xy_low = detail::picked(a, b, x_then_y, places), xy_high = detail::picked(c, d, x_then_y, places);
            x[p] = detail::picked(xy_low, xy_high, first_halves, places);
            y[p] = detail::picked(xy_low, xy_high, second_halves, places);
            z[p] = detail::picked(detail::picked(a, b, z_then_none, places),
                                  detail::picked(c, d, z_then_none, places), first_halves, places);
        }
        return {N(x), N(y), N(z)};
    }
}

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
