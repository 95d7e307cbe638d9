#pragma once

#include "core/vec3.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace steplab {

class Team;

/// Particles that are near each other in clusters of four, so that those within reach of each other are found by pairs
/// of clusters (cluster_pairs.hpp): what a kernel needs that computes 4 x 4 pairs in registers (Pall and Hess, Comput.
/// Phys. Commun. 184 (2013) 2641). Columns along z have a cross-section about as wide as a cluster; the particles of a
/// column, from below, four by four, are its clusters. All of it depends on the positions alone.
///
/// With a period, space repeats itself along each axis: a pair of clusters says which image of the second it means.
class Clusters {
public:
    static constexpr std::size_t size = 4;
    /// Images of space: 9 (x + 1) + 3 (y + 1) + z + 1 for the one x, y, z periods away.
    static constexpr std::uint32_t own_image = 13, images = 27;
    static constexpr std::size_t spare = 64;  ///< of places()
    /// As many clusters can be told apart.
    static constexpr std::size_t most = std::size_t{1} << 27;

    /// The second cluster of a pair, and its image.
    class Other {
    public:
        Other() = default;
        Other(std::uint32_t cluster, std::uint32_t image) : bits_(cluster << 5 | image) {}
        std::uint32_t cluster() const { return bits_ >> 5; }
        std::uint32_t image() const { return bits_ & 31; }

    private:
        std::uint32_t bits_ = 0;
    };

    /// How far away, in periods, an image is along an axis.
    static int periods(std::uint32_t image, std::size_t axis) {
        constexpr std::array<std::uint32_t, 3> weight{9, 3, 1};
        return static_cast<int>(image / weight[axis] % 3) - 1;
    }

    /// Tells where a particle is; with a period, where that of its images is which is within half a period of the
    /// origin.
    using Position = std::function<Vec3(std::size_t)>;
    /// A period is 0 for none, else at least `reach`. Particles that are nowhere are in clusters without pairs. The
    /// team shares the sorting.
    void make(std::size_t particles, const Position& position, double reach, double period, Team& team);

    std::size_t count() const { return count_; }
    /// Clusters from `begin` to `end`, those of columns side by side. So thick that a pair of clusters is within one
    /// slab, or in it and the next one, images along x set aside: only the first slab lists pairs with those.
    struct Slab {
        std::uint32_t begin, end;
        std::size_t first_column, end_column;
    };
    /// All clusters; few of them are one slab.
    std::span<const Slab> slabs() const { return slabs_; }
    /// Of each particle: the cluster times four, plus its place there. Behind them, for whoever goes through particles
    /// some at a time and looks ahead, `spare` times the last place of a cluster behind all others.
    std::span<const std::uint32_t> places() const { return places_; }

    /// Clusters of one column follow each other, from below upwards.
    struct Column {
        std::uint32_t x, y;
        std::uint32_t begin, end;  ///< its clusters
    };
    std::span<const Column> columns() const { return columns_; }
    /// Null if nobody is there.
    const Column* column(int x, int y) const;
    /// With a period, 0 without.
    std::uint32_t columns_a_row() const { return columns_a_row_; }
    /// How many columns away somebody may be within reach.
    std::uint32_t range() const;
    /// Where the particles of clusters are, along one axis: low above high if they are nowhere. After the last, some
    /// more that are infinitely far away, so that `side_by_side` can be read from each on.
    struct Bounds {
        std::vector<float> low, high;
    };
    static constexpr std::size_t side_by_side = 8;
    const Bounds& bounds(std::size_t axis) const { return bounds_[axis]; }
    double reach() const { return reach_; }
    double period() const { return period_; }

private:
    /// Sorts particles by column, then from below.
    struct Placed {
        std::uint64_t key;
        std::uint32_t particle;
    };
    void choose_columns(std::size_t particles, const Position& position);
    std::uint32_t column_at(double position) const;
    std::uint64_t key_at(Vec3 position) const;
    std::vector<std::uint32_t> former_order(std::size_t particles) const;
    void sort(std::size_t particles, const Position& position, Team& team);
    std::vector<std::uint32_t> form_clusters();
    void find_bounds(std::span<const std::uint32_t> firsts, const Position& position, Team& team);
    void include(std::size_t cluster, Vec3 position);
    void form_slabs();

    double reach_ = 0, period_ = 0;
    double width_ = 1;                 ///< of a column
    std::uint32_t columns_a_row_ = 0;  ///< with a period
    std::vector<Placed> placed_;
    std::vector<std::uint32_t> places_;
    std::vector<Column> columns_;
    std::size_t count_ = 0;
    std::array<Bounds, 3> bounds_;
    std::vector<Slab> slabs_;
};

/// Calls f(squares of distances), some at a time, for all pairs of particles nearer than the cut-off; the rest as for
/// Clusters::make().
void each_near_distance2(std::size_t particles, const Clusters::Position& position, double cutoff, double period,
                         Team& team, const std::function<void(std::span<const double>)>& f);

}  // namespace steplab
