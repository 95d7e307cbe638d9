#pragma once

#include "sim/ensemble/live_ensemble.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace steplab {

/// How many changes of a run were done to another one, too: at the same steps, from the first on.
inline std::size_t same_changes(std::span<const SegmentBegin> a, std::span<const SegmentBegin> b) {
    const auto [here, there] =
        std::mismatch(a.begin(), a.end(), b.begin(), b.end(), [](const SegmentBegin& one, const SegmentBegin& other) {
            return one.step == other.step && one.description == other.description && one.act == other.act;
        });
    return static_cast<std::size_t>(here - a.begin());
}

/// The first step at which what was done to them differs; none if all of it is the same.
inline std::optional<std::uint64_t> first_difference(std::span<const SegmentBegin> a, std::span<const SegmentBegin> b) {
    const std::size_t same = same_changes(a, b);
    std::optional<std::uint64_t> first;
    for (const auto changes : {a, b}) {
        if (same < changes.size()) first = std::min(first.value_or(changes[same].step), changes[same].step);
    }
    return first;
}

}  // namespace steplab
