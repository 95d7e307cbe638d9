#pragma once

#include "core/lanes.hpp"

#include <array>
#include <cstddef>
#include <utility>

namespace steplab {

namespace detail {

template <std::size_t Shift, class Register, std::size_t... I>
[[gnu::always_inline]] inline Register lanes_from(Register a, Register b, std::index_sequence<I...>) {
    return __builtin_shufflevector(a, b, static_cast<int>(I + Shift)...);
}

/// Every other group of `Half` lanes of a and b, starting with the group at lane `Begin`.
template <std::size_t Half, std::size_t Begin, class Register, std::size_t... I>
[[gnu::always_inline]] inline Register every_other(Register a, Register b, std::index_sequence<I...>) {
    return __builtin_shufflevector(a, b, static_cast<int>(I / Half * 2 * Half + I % Half + Begin)...);
}

}  // namespace detail

/// Lane l of the result is lane l + Shift, cyclically.
template <std::size_t Shift, class T, std::size_t Count>
[[gnu::always_inline]] inline RegisterLanes<T, Count> rotated(const RegisterLanes<T, Count>& lanes) {
    using N = RegisterLanes<T, Count>;
    const auto& from = lanes.registers();
    std::array<typename N::Register, N::parts> to;
    for (std::size_t p = 0; p < N::parts; ++p) {
        const auto& begin = from[(p + Shift / N::width) % N::parts];
        const auto& rest = from[(p + Shift / N::width + 1) % N::parts];
        to[p] = detail::lanes_from<Shift % N::width>(begin, rest, std::make_index_sequence<N::width>{});
    }
    return N(to);
}

/// The lanes of a and then of b in groups of 2 Half: of each group the first half plus the second.
template <std::size_t Half, class T, std::size_t Count>
[[gnu::always_inline]] inline RegisterLanes<T, Count> folded(const RegisterLanes<T, Count>& a,
                                                             const RegisterLanes<T, Count>& b) {
    using N = RegisterLanes<T, Count>;
    const auto part = [&](std::size_t p) { return p < N::parts ? a.registers()[p] : b.registers()[p - N::parts]; };
    std::array<typename N::Register, N::parts> sums;
    for (std::size_t p = 0; p < N::parts; ++p) {
        if constexpr (Half >= N::width) {
            const std::size_t lane = p * N::width, first = lane / Half * 2 * Half + lane % Half;
            sums[p] = part(first / N::width) + part((first + Half) / N::width);
        } else {
            constexpr std::make_index_sequence<N::width> places{};
            const auto first = part(2 * p), second = part(2 * p + 1);
            sums[p] = detail::every_other<Half, 0>(first, second, places) +
                      detail::every_other<Half, Half>(first, second, places);
        }
    }
    return N(sums);
}

/// Lane l of the result is the sum of the lanes of row l, of as many rows as lanes: the first half of a row plus the
/// second, lane by lane, until one is left.
template <class N, std::size_t Rows = N::count>
[[gnu::always_inline]] inline N sums_of_rows(const N* rows) {
    if constexpr (Rows == 1) {
        return *rows;
    } else {
        constexpr std::size_t half = Rows / 2;
        return folded<N::count / Rows>(sums_of_rows<N, half>(rows), sums_of_rows<N, half>(rows + half));
    }
}

}  // namespace steplab
