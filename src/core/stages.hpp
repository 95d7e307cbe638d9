#pragma once

#include "core/lanes.hpp"

#include <cstddef>
#include <type_traits>

namespace steplab {

inline constexpr std::size_t stage_count = 8;

/// One quantity at the eight stages of a step, in SIMD lanes: a number type for the force formulas, one vector register
/// where the machine has registers of that width.
template <class T>
using Stages = std::conditional_t<std::is_same_v<T, float> || std::is_same_v<T, double>, RegisterLanes<T, stage_count>,
                                  PlainLanes<T, stage_count>>;

/// A number type with SIMD lanes.
template <class N>
concept HasLanes = requires(const N& n) {
    N::count;
    n[0];
};

/// e^x in every lane, bit-identical to exponential() of a single number.
template <HasLanes N>
N exponential(const N& x) {
    using T = std::remove_cvref_t<decltype(x[0])>;
    alignas(64) T numbers[N::count];
    x.store(numbers);
    for (std::size_t lane = 0; lane < N::count; ++lane) numbers[lane] = exponential(numbers[lane]);
    return N::load(numbers);
}

/// True if the condition holds in any lane.
template <class Mask>
bool any(const Mask& condition, std::size_t lanes) {
    bool found = false;
    for (std::size_t lane = 0; lane < lanes; ++lane) found = found || condition[lane];
    return found;
}

}  // namespace steplab
