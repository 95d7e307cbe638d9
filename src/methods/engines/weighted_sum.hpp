#pragma once

#include "core/lanes.hpp"

#include <array>
#include <cstddef>
#include <type_traits>
#include <utility>

namespace steplab {

namespace detail {

/// True if one of the first `count` weights is not zero.
template <class Weights>
constexpr bool any_before(std::size_t count) {
    for (std::size_t j = 0; j < count; ++j) {
        if (Weights::weights[j] != 0) return true;
    }
    return false;
}

}  // namespace detail

/// `sum`, the first First terms of w_0 p_0 + w_1 p_1 + ..., continued by those behind them, from left to right: of the
/// numbers in the register that begins at place k. `Weights::weights` is known at compile time, so that terms whose
/// weight is zero are left out.
template <class Weights, std::size_t First, class T, std::size_t M>
[[gnu::always_inline]] inline Lanes<T> with_terms(Lanes<T> sum, const std::array<const T*, M>& terms, std::size_t k) {
    const auto add = [&]<std::size_t J>(std::integral_constant<std::size_t, J>) __attribute__((always_inline)) {
        constexpr auto weight = Weights::weights[J];
        if constexpr (weight == 0) {
            return;
        } else if constexpr (!detail::any_before<Weights>(J)) {
            sum = Lanes<T>(static_cast<T>(weight)) * Lanes<T>::load(terms[J] + k);
        } else {
            sum = sum + Lanes<T>(static_cast<T>(weight)) * Lanes<T>::load(terms[J] + k);
        }
    };
    [&]<std::size_t... J>(std::index_sequence<J...>) __attribute__((always_inline)) {
        (add(std::integral_constant<std::size_t, First + J>{}), ...);
    }
    (std::make_index_sequence<M - First>{});
    return sum;
}

/// The whole sum.
template <class Weights, class T, std::size_t M>
[[gnu::always_inline]] inline Lanes<T> weighted_sum(const std::array<const T*, M>& terms, std::size_t k) {
    return with_terms<Weights, 0>(Lanes<T>(T(0)), terms, k);
}

}  // namespace steplab
