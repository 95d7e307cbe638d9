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

/// w_0 p_0 + ... + w_(M-1) p_(M-1) of the numbers in the register that begins at place k, from left to right.
/// `Weights::weights` is known at compile time, so that terms whose weight is zero are left out.
template <class Weights, class T, std::size_t M>
Lanes<T> weighted_sum(const std::array<const T*, M>& terms, std::size_t k) {
    const auto add = [&]<std::size_t J>(Lanes<T>& sum, std::integral_constant<std::size_t, J>) {
        constexpr auto weight = Weights::weights[J];
        if constexpr (weight == 0) {
            return;
        } else if constexpr (!detail::any_before<Weights>(J)) {
            sum = Lanes<T>(static_cast<T>(weight)) * Lanes<T>::load(terms[J] + k);
        } else {
            sum = sum + Lanes<T>(static_cast<T>(weight)) * Lanes<T>::load(terms[J] + k);
        }
    };
    Lanes<T> sum(T(0));
    [&]<std::size_t... J>(std::index_sequence<J...>) { (add(sum, std::integral_constant<std::size_t, J>{}), ...); }
    (std::make_index_sequence<M>{});
    return sum;
}

}  // namespace steplab
