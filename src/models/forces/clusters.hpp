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

/// Groups nearby particles into clusters of four, so that particles within reach of each other are found by pairs of
/// clusters (cluster_pairs.hpp), for a kernel that computes 4 x 4 pairs in registers (Pall and Hess, Comput. Phys.
/// Commun. 184 (2013) 2641). Columns along z are about as wide as a cluster; each four consecutive particles of a
/// column, by increasing z, are a cluster. The result depends on the positions alone.
///
/// With periodic boundary conditions, a pair of clusters also names the image of the second one.
class Clusters {
public:
    static constexpr std::size_t size = 4;
    /// Periodic images: 9 (x + 1) + 3 (y + 1) + z + 1 for the image x, y, z periods away.
    static constexpr std::uint32_t own_image = 13, images = 27;
    static constexpr std::size_t spare = 64;  ///< of places()
    /// Largest number of clusters that can be numbered.
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

    /// Distance of an image along an axis, in periods.
    static int periods(std::uint32_t image, std::size_t axis) {
        constexpr std::array<std::uint32_t, 3> weight{9, 3, 1};
        return static_cast<int>(image / weight[axis] % 3) - 1;
    }

    /// The position of a particle; with periodic boundary conditions, of its image within half a period of the origin.
    using Position = std::function<Vec3(std::size_t)>;
    /// `period` is 0 (none) or at least `reach`. Particles without a valid position are put into clusters without
    /// pairs. The team shares the sorting.
    void make(std::size_t particles, const Position& position, double reach, double period, Team& team);

    std::size_t count() const { return count_; }
    /// Clusters from `begin` to `end`, those of adjacent columns. A slab is thick enough that a pair of clusters is
    /// within one slab or in two consecutive ones, except for images along x: only the first slab lists pairs with
    /// those.
    struct Slab {
        std::uint32_t begin, end;
        std::size_t first_column, end_column;
    };
    /// All clusters; a small number of them is one slab.
    std::span<const Slab> slabs() const { return slabs_; }
    /// For each particle: four times its cluster, plus its place there. After them, `spare` times the last place of a
    /// cluster beyond all others, for loops that read ahead.
    std::span<const std::uint32_t> places() const { return places_; }

    /// The clusters of one column are consecutive, by increasing z.
    struct Column {
        std::uint32_t x, y;
        std::uint32_t begin, end;  ///< its clusters
    };
    std::span<const Column> columns() const { return columns_; }
    /// Null if it has no particles.
    const Column* column(int x, int y) const;
    /// Number of columns along an axis of the periodic box; 0 without.
    std::uint32_t columns_a_row() const { return columns_a_row_; }
    /// Largest distance, in columns, at which particles may be within reach.
    std::uint32_t range() const;
    /// Bounds of the clusters along one axis; low is above high if no particle has a valid position. Padded with
    /// infinitely distant ones, so that `side_by_side` bounds can be read from each index.
    struct Bounds {
        std::vector<float> low, high;
    };
    static constexpr std::size_t side_by_side = 8;
    const Bounds& bounds(std::size_t axis) const { return bounds_[axis]; }
    double reach() const { return reach_; }
    double period() const { return period_; }

private:
    /// Sorts particles by column, then by z.
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

/// Calls f(squared distances), several at a time, for all pairs of particles nearer than the cut-off; other parameters
/// as for Clusters::make().
void each_near_distance2(std::size_t particles, const Clusters::Position& position, double cutoff, double period,
                         Team& team, const std::function<void(std::span<const double>)>& f);

}  // namespace steplab
