#pragma once

#include "models/scene/scene_particles.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace steplab {

/// A set of particles given as ranges of their indices.
class ParticleSet {
public:
    ParticleSet() = default;
    explicit ParticleSet(std::vector<IndexRange> ranges) : ranges_(std::move(ranges)) {
        std::sort(ranges_.begin(), ranges_.end(), [](IndexRange a, IndexRange b) { return a.first < b.first; });
        std::vector<IndexRange> joined;
        for (const IndexRange range : ranges_) {
            if (joined.empty() || range.first > end_of(joined.back()))
                joined.push_back(range);
            else
                joined.back().count = std::max(end_of(joined.back()), end_of(range)) - joined.back().first;
        }
        ranges_ = std::move(joined);
    }

    bool contains(std::size_t i) const {
        const auto after = std::upper_bound(ranges_.begin(), ranges_.end(), i,
                                            [](std::size_t index, IndexRange range) { return index < range.first; });
        return after != ranges_.begin() && i < end_of(*std::prev(after));
    }
    /// True if a particle is in both.
    bool overlaps(const ParticleSet& other) const {
        return std::any_of(ranges_.begin(), ranges_.end(), [&](IndexRange a) {
            return std::any_of(other.ranges_.begin(), other.ranges_.end(),
                               [&](IndexRange b) { return a.first < end_of(b) && b.first < end_of(a); });
        });
    }
    bool operator==(const ParticleSet&) const = default;

private:
    static std::size_t end_of(IndexRange range) { return range.first + range.count; }

    std::vector<IndexRange> ranges_;  ///< ascending, none touches another
};

}  // namespace steplab
