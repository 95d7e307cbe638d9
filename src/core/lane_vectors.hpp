#pragma once

#include "core/lanes.hpp"
#include "core/vector.hpp"

#include <array>
#include <cstddef>
#include <cstring>
#include <type_traits>
#include <utility>

namespace steplab {

// Rearrangement of lanes. T is float or double.

namespace detail {

/// Numbers in a register of these lanes.
template <class T, std::size_t Count>
inline constexpr std::size_t width_of = sizeof(typename RegisterLanes<T, Count>::Register) / sizeof(T);

template <class T, std::size_t Count, std::size_t First, std::size_t... I>
[[gnu::always_inline]] inline RegisterLanes<T, Count / 2> half(typename RegisterLanes<T, Count>::Register lanes,
                                                               std::index_sequence<I...>) {
    return RegisterLanes<T, Count / 2>(__builtin_shufflevector(lanes, lanes, static_cast<int>(I + First)...));
}

/// Calls f(E, four) for every four numbers of a register.
template <class T, class Register, class F, std::size_t... E>
[[gnu::always_inline]] inline void each_four(Register vectors, F f, std::index_sequence<E...>) {
    constexpr auto at = [](std::size_t place) { return static_cast<int>(place); };
    (f(E, RegisterLanes<T, 4>(
              __builtin_shufflevector(vectors, vectors, at(4 * E), at(4 * E + 1), at(4 * E + 2), at(4 * E + 3)))),
     ...);
}

/// Lane I of the result is lane F(I) of a followed by b.
template <class Vectors, class F, std::size_t... I>
[[gnu::always_inline]] inline auto picked(Vectors a, Vectors b, F, std::index_sequence<I...>) {
    return __builtin_shufflevector(a, b, static_cast<int>(std::integral_constant<std::size_t, F{}(I)>::value)...);
}

/// `Width` numbers in groups of four, loaded from address(E), E = First, First + 1, ...
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

/// x, y and z of Count / 4 vectors, each in four lanes; vector j is stored at address(j) as three numbers and an unused
/// one, aligned to four numbers.
template <class T, std::size_t Count, class F>
[[gnu::always_inline]] inline Vector<RegisterLanes<T, Count>> repeated_vectors(F address) {
    using N = RegisterLanes<T, Count>;
    if constexpr (N::width < 4) {
        const auto along = [&](std::size_t axis) {
            return N::each([&](std::size_t lane) { return address(lane / 4)[axis]; });
        };
        return {along(0), along(1), along(2)};
    } else {
        std::array<typename N::Register, N::parts> x, y, z;
        constexpr std::make_index_sequence<N::width> places{};
        constexpr auto first = [](std::size_t lane) { return lane / 4 * 4; };
        constexpr auto second = [](std::size_t lane) { return lane / 4 * 4 + 1; };
        constexpr auto third = [](std::size_t lane) { return lane / 4 * 4 + 2; };
        for (std::size_t p = 0; p < N::parts; ++p) {
            const auto vectors =
                detail::fours<T, N::width, 0>([&](std::size_t j) { return address(p * N::width / 4 + j); });
            x[p] = detail::picked(vectors, vectors, first, places);
            y[p] = detail::picked(vectors, vectors, second, places);
            z[p] = detail::picked(vectors, vectors, third, places);
        }
        return {N(x), N(y), N(z)};
    }
}

/// x, y and z of Count vectors, one in each lane; vector j is stored as above.
template <class T, std::size_t Count, class F>
[[gnu::always_inline]] inline Vector<RegisterLanes<T, Count>> gathered_vectors(F address) {
    using N = RegisterLanes<T, Count>;
    if constexpr (N::width < 4) {
        const auto along = [&](std::size_t axis) {
            return N::each([&](std::size_t lane) { return address(lane)[axis]; });
        };
        return {along(0), along(1), along(2)};
    } else {
        constexpr std::size_t width = N::width, half = width / 2;
        constexpr std::make_index_sequence<width> places{};
        // of the vectors in two registers: all x and then all y; all z twice
        constexpr auto xy = [](std::size_t i) { return i < half ? 4 * i : 4 * (i - half) + 1; };
        constexpr auto zz = [](std::size_t i) { return 4 * (i % half) + 2; };
        constexpr auto firsts = [](std::size_t i) { return i < half ? i : i + half; };
        constexpr auto seconds = [](std::size_t i) { return i < half ? i + half : i + width; };
        std::array<typename N::Register, N::parts> x, y, z;
        for (std::size_t p = 0; p < N::parts; ++p) {
            const auto at = [&](std::size_t j) __attribute__((always_inline)) { return address(p * width + j); };
            const auto a = detail::fours<T, width, 0>(at), b = detail::fours<T, width, width / 4>(at);
            const auto c = detail::fours<T, width, half>(at), d = detail::fours<T, width, width / 4 * 3>(at);
            const auto xy1 = detail::picked(a, b, xy, places), xy2 = detail::picked(c, d, xy, places);
            x[p] = detail::picked(xy1, xy2, firsts, places);
            y[p] = detail::picked(xy1, xy2, seconds, places);
            z[p] = detail::picked(detail::picked(a, b, zz, places), detail::picked(c, d, zz, places), firsts, places);
        }
        return {N(x), N(y), N(z)};
    }
}

/// Calls f(j, four) for every lane j with its x, y and z and an unused number.
template <class T, std::size_t Count, class F>
[[gnu::always_inline]] inline void each_vector(const Vector<RegisterLanes<T, Count>>& v, F f) {
    using N = RegisterLanes<T, Count>;
    if constexpr (N::width < 4) {
        for (std::size_t j = 0; j < Count; ++j) {
            const std::array<T, 4> vector{v.x[j], v.y[j], v.z[j], v.z[j]};
            f(j, RegisterLanes<T, 4>::each([&](std::size_t axis) { return vector[axis]; }));
        }
    } else {
        constexpr std::size_t width = N::width;
        constexpr std::make_index_sequence<width> places{};
        // lane after lane of the first half of the lanes of both registers; then of the second half
        constexpr auto low = [](std::size_t i) { return i / 2 + i % 2 * width; };
        constexpr auto high = [](std::size_t i) { return i / 2 + width / 2 + i % 2 * width; };
        // two numbers of each in turns
        constexpr auto low_pairs = [](std::size_t i) { return i / 4 * 2 + i % 2 + i % 4 / 2 * width; };
        constexpr auto high_pairs = [](std::size_t i) { return i / 4 * 2 + width / 2 + i % 2 + i % 4 / 2 * width; };
        for (std::size_t p = 0; p < N::parts; ++p) {
            const auto x = v.x.registers()[p], y = v.y.registers()[p], z = v.z.registers()[p];
            std::size_t first = p * width;
            const auto emit = [&](auto vectors) __attribute__((always_inline)) {
                detail::each_four<T>(
                    vectors, [&](std::size_t j, const auto& four) { f(first + j, four); },
                    std::make_index_sequence<width / 4>{});
                first += width / 4;
            };
            const auto xy1 = detail::picked(x, y, low, places), zz1 = detail::picked(z, z, low, places);
            const auto xy2 = detail::picked(x, y, high, places), zz2 = detail::picked(z, z, high, places);
            emit(detail::picked(xy1, zz1, low_pairs, places)), emit(detail::picked(xy1, zz1, high_pairs, places));
            emit(detail::picked(xy2, zz2, low_pairs, places)), emit(detail::picked(xy2, zz2, high_pairs, places));
        }
    }
}

/// Four numbers, aligned to four numbers, repeated in every group of four lanes.
template <class T, std::size_t Count>
[[gnu::always_inline]] inline RegisterLanes<T, Count> repeated_four(const T* four) {
    using N = RegisterLanes<T, Count>;
    if constexpr (N::width < 4) {
        return N::each([=](std::size_t lane) { return four[lane % 4]; });
    } else {
        std::array<typename N::Register, N::parts> registers;
        registers.fill(detail::fours<T, N::width, 0>([=](std::size_t) { return four; }));
        return N(registers);
    }
}

/// Calls f(j, four) for every group j of four lanes with its sums of x, y and z and an unused number. The sum of lanes
/// 0 to 3 is (0 + 1) + (2 + 3).
template <class T, std::size_t Count, class F>
[[gnu::always_inline]] inline void each_sum_of_four(const Vector<RegisterLanes<T, Count>>& v, F f) {
    using N = RegisterLanes<T, Count>;
    if constexpr (N::width < 4) {
        for (std::size_t j = 0; j < Count / 4; ++j) {
            const auto sum = [j](const N& n) { return (n[4 * j] + n[4 * j + 1]) + (n[4 * j + 2] + n[4 * j + 3]); };
            const std::array<T, 3> sums{sum(v.x), sum(v.y), sum(v.z)};
            f(j, RegisterLanes<T, 4>::each([&](std::size_t axis) { return sums[axis % 3]; }));
        }
    } else {
        constexpr std::make_index_sequence<N::width> places{};
        // of every four lanes, 0 and 2 of both registers alternately; then 1 and 3
        constexpr auto even = [](std::size_t i) { return i / 2 * 2 + i % 2 * N::width; };
        constexpr auto odd = [](std::size_t i) { return i / 2 * 2 + 1 + i % 2 * N::width; };
        // the first two of both; then the second two
        constexpr auto firsts = [](std::size_t i) { return i / 4 * 4 + i % 2 + i % 4 / 2 * N::width; };
        constexpr auto seconds = [](std::size_t i) { return i / 4 * 4 + i % 2 + 2 + i % 4 / 2 * N::width; };
        for (std::size_t p = 0; p < N::parts; ++p) {
            const auto x = v.x.registers()[p], y = v.y.registers()[p], z = v.z.registers()[p];
            const auto xy = detail::picked(x, y, even, places) + detail::picked(x, y, odd, places);
            const auto zz = detail::picked(z, z, even, places) + detail::picked(z, z, odd, places);
            detail::each_four<T>(
                detail::picked(xy, zz, firsts, places) + detail::picked(xy, zz, seconds, places),
                [&](std::size_t j, const auto& four) { f(p * N::width / 4 + j, four); },
                std::make_index_sequence<N::width / 4>{});
        }
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

}  // namespace steplab
