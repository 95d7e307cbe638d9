#pragma once

#include "models/forces/composition.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace steplab {

/// Which particles a term of pair forces joins: those of two sets, or of one.
class PairSides {
public:
    PairSides(const ComposedPairs& pairs, std::size_t count) : sides_(count) {
        for (const std::uint32_t i : pairs.first) sides_[i] = pairs.second.empty() ? 3 : 1;
        for (const std::uint32_t i : pairs.second) sides_[i] = sides_[i] == 1 ? 3 : 2;
        for (std::uint32_t i = 0; i < count; ++i) {
            for (const unsigned side : {1U, 2U, 3U}) {
                if ((sides_[i] & side) != 0) on_[side].push_back(i);
            }
        }
    }

    std::size_t count() const { return sides_.size(); }
    /// Calls f(i, j), i < j, for all that are joined, in ascending order.
    template <class F>
    void each(F f) const {
        for (const std::uint32_t i : on_[3]) {
            const std::vector<std::uint32_t>& others = on_[opposite(sides_[i])];
            for (auto j = std::upper_bound(others.begin(), others.end(), i); j != others.end(); ++j)
                f(std::size_t{i}, std::size_t{*j});
        }
    }
    bool has(std::size_t i) const { return sides_[i] != 0; }
    bool joins(std::size_t i, std::size_t j) const {
        return ((sides_[i] & 1) != 0 && (sides_[j] & 2) != 0) || ((sides_[i] & 2) != 0 && (sides_[j] & 1) != 0);
    }
    /// True if j stands before i in the order in which the two sets are named.
    bool turned(std::size_t i, std::size_t j) const { return sides_[i] == 2 || (sides_[i] == 3 && sides_[j] == 1); }

private:
    static unsigned opposite(unsigned side) { return side == 3 ? 3 : 3 - side; }

    /// 1 for the particles of the first set, 2 for those of the second, 3 within one.
    std::vector<unsigned char> sides_;
    std::array<std::vector<std::uint32_t>, 4> on_;  ///< those of the first set, of the second, of any, ascending
};

}  // namespace steplab
