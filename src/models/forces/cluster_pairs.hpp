#pragma once

#include "core/compressed_lanes.hpp"
#include "core/lanes.hpp"
#include "models/forces/clusters.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace steplab {

/// The pairs of clusters that may contain two particles within reach of each other. Refers to the clusters.
class ClusterPairs {
public:
    using Other = Clusters::Other;

    explicit ClusterPairs(const Clusters& clusters)
        : clusters_(clusters),
          reach_(static_cast<float>(clusters.reach())),
          reach2_(static_cast<float>(clusters.reach() * clusters.reach())),
          period_(static_cast<float>(clusters.period())) {}

    /// Calls f(cluster, others), others a span of Other, for each cluster of a slab in turn. Each pair of clusters,
    /// with its image, is listed once, with the cluster whose slab comes first; a cluster is not paired with itself.
    /// Clusters of particles without a valid position are left out.
    template <class F>
    void each(const Clusters::Slab& slab, F f) {
        for (std::size_t k = slab.first_column; k < slab.end_column; ++k) {
            const Clusters::Column& column = clusters_.columns()[k];
            find_adjacent(column);
            for (std::uint32_t cluster = column.begin; cluster < column.end; ++cluster) {
                const Box box = box_of(cluster);
                if (box.high[0] < box.low[0]) continue;
                count_ = 0;
                for (Adjacent& adjacent : adjacent_) append_others(box, adjacent);
                f(cluster, std::span<const Other>(others_.data(), count_));
            }
        }
    }

private:
    /// Clusters whose distances are computed in SIMD lanes.
    using Lanes = RegisterLanes<float, Clusters::side_by_side>;

    /// A column, or an image of it, that may be within reach of the column being processed.
    struct Adjacent {
        std::uint32_t begin, end;
        int x, y;                            ///< image
        std::array<std::uint32_t, 3> first;  ///< first cluster that may be within reach, for each image along z
    };
    /// Bounding box of a cluster, and the images along z that may be within its reach.
    struct Box {
        std::uint32_t cluster;
        std::array<float, 3> low, high;
        int first_z, last_z;
    };

    /// Columns before this one have already listed their pairs with it.
    void find_adjacent(const Clusters::Column& column) {
        adjacent_.clear();
        const int around = static_cast<int>(clusters_.range()), row = static_cast<int>(clusters_.columns_a_row());
        const auto in_period = [row](int& at) {
            if (row == 0) return 0;
            const int image = at < 0 ? -1 : at >= row ? 1 : 0;
            at -= image * row;
            return image;
        };
        for (int dx = -around; dx <= around; ++dx) {
            for (int dy = -around; dy <= around; ++dy) {
                int x = static_cast<int>(column.x) + dx, y = static_cast<int>(column.y) + dy;
                const int image_x = in_period(x), image_y = in_period(y);
                const Clusters::Column* const found = clusters_.column(x, y);
                if (!found || found->begin < column.begin) continue;
                const std::uint32_t first = found->begin;
                adjacent_.push_back({first, found->end, image_x, image_y, {first, first, first}});
            }
        }
    }

    Box box_of(std::uint32_t cluster) const {
        Box box{cluster, {}, {}, 0, 0};
        for (std::size_t axis = 0; axis < 3; ++axis) {
            box.low[axis] = clusters_.bounds(axis).low[cluster];
            box.high[axis] = clusters_.bounds(axis).high[cluster];
        }
        if (period_ == 0) return box;
        // an image extends half a period from its centre
        const float half = period_ / 2;
        box.first_z = reach_ - box.low[2] >= half ? -1 : 0;
        box.last_z = box.high[2] + reach_ >= half ? 1 : 0;
        return box;
    }

    /// The clusters of a column are ordered by increasing z, and so are those within their reach.
    void append_others(const Box& box, Adjacent& adjacent) {
        const float* const high = clusters_.bounds(2).high.data();
        const float lowest = box.low[2] - reach_;
        for (int z = box.first_z; z <= box.last_z; ++z) {
            const float shift = static_cast<float>(z) * period_;
            const int place = z + 1;
            std::uint32_t& first = adjacent.first[static_cast<std::size_t>(place)];
            while (first < adjacent.end && high[first] + shift < lowest) ++first;
            const auto image = static_cast<std::uint32_t>(9 * (adjacent.x + 1) + 3 * (adjacent.y + 1) + z + 1);
            // each pair once
            const bool later = image > Clusters::own_image;
            const std::uint32_t from = std::max(first, later ? box.cluster : box.cluster + 1);
            if (image == Clusters::own_image) {
                append_within_reach(box, from, adjacent.end, image);
            } else {
                append_within_reach(moved_back(box, image), from, adjacent.end, image);
            }
        }
    }

    /// The box shifted so that it relates to the original as `box` relates to the image.
    Box moved_back(Box box, std::uint32_t image) const {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const float shift = static_cast<float>(Clusters::periods(image, axis)) * period_;
            box.low[axis] -= shift;
            box.high[axis] -= shift;
        }
        return box;
    }

    /// Appends clusters of one column. Without branches, because about half of the clusters are near.
    void append_within_reach(const Box& box, std::uint32_t from, std::uint32_t to, std::uint32_t image) {
        const float highest = box.high[2] + reach_;
        const float* const low = clusters_.bounds(2).low.data();
        for (std::uint32_t other = from; other < to && low[other] <= highest; other += Lanes::count) {
            const LaneSet beyond = lanes_below(Lanes(reach2_), distance2(box, other));
            const LaneSet near = ~beyond & first_lanes(to - other);
            if (others_.size() < count_ + Lanes::count) others_.resize(2 * others_.size() + Lanes::count);
            for (std::uint32_t lane = 0; lane < Lanes::count; ++lane) {
                others_[count_] = Other(other + lane, image);
                count_ += near >> lane & 1;
            }
        }
    }
    /// Squared distances to the clusters from `other` on.
    [[gnu::always_inline]] Lanes distance2(const Box& box, std::uint32_t other) const {
        Lanes sum(0.0F);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const Clusters::Bounds& bounds = clusters_.bounds(axis);
            const Lanes up = Lanes::load_anywhere(bounds.low.data() + other) - Lanes(box.high[axis]);
            const Lanes down = Lanes(box.low[axis]) - Lanes::load_anywhere(bounds.high.data() + other);
            const Lanes apart = where(up < down, down, up), none(0.0F);
            const Lanes gap = where(none < apart, apart, none);
            sum += gap * gap;
        }
        return sum;
    }

    const Clusters& clusters_;
    float reach_, reach2_, period_;
    std::vector<Adjacent> adjacent_;
    std::vector<Other> others_;  ///< of the current cluster: the first count_ elements
    std::size_t count_ = 0;
};

}  // namespace steplab
