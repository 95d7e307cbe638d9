#pragma once

#include "core/field.hpp"
#include "core/stages.hpp"
#include "core/vec3.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

namespace steplab {

/// Neighbour lists (Verlet lists; Verlet, Phys. Rev. 159 (1967) 98): for each particle the others within reach, in the
/// order of their indices. The reach is the cut-off plus a skin, so that a list stays valid until a particle has moved
/// by half the skin. With a period (not 0) there are periodic boundary conditions, and the nearest image of a particle
/// counts.
class Neighbours {
public:
    explicit Neighbours(double cutoff, double period = 0) : Neighbours(cutoff, Vec3{period, period, period}) {}
    /// In a box of these sides; 0: open along that axis.
    Neighbours(double cutoff, Vec3 box)
        : cutoff_(cutoff),
          x_{box.x},
          y_{box.y},
          z_{box.z},
          skin_(0.15 * cutoff),
          allowed_(0.45 * skin_),
          reach_(cutoff + skin_) {}

    /// Renews the lists if a particle has moved too far since they were made. For number types with lanes, the lists
    /// are valid for the positions in every lane: their reach is larger by the distance between lanes.
    template <class T>
    void follow(const Field<T>& positions) {
        if (made_at_.size() == positions.count() && !moved_too_far(positions)) return;
        made_at_.resize(positions.count());
        for (std::size_t i = 0; i < made_at_.size(); ++i) made_at_[i] = position(positions, i, lanes_of<T> / 2);
        const double apart = lanes_of<T> > 1 ? spread(positions) : 0;
        allowed_ = 0.45 * skin_ + apart;
        reach_ = cutoff_ + skin_ + apart / 0.45;
        make_lists();
    }

    std::span<const std::uint32_t> of(std::size_t i) const {
        return {list_.data() + begin_[i], list_.data() + begin_[i + 1]};
    }

private:
    /// A particle in the cell with this key.
    struct Placed {
        std::uint64_t cell;
        std::uint32_t index;
    };

    template <class T>
    static constexpr std::size_t lanes_of = [] {
        if constexpr (HasLanes<T>) return T::count;
        return std::size_t{1};
    }();

    template <class T>
    static Vec3 position(const Field<T>& positions, std::size_t i, std::size_t lane) {
        if constexpr (HasLanes<T>) {
            const auto number = [lane](const T& lanes) { return static_cast<double>(lanes[lane]); };
            return {number(positions.x()[i]), number(positions.y()[i]), number(positions.z()[i])};
        } else {
            return positions.at(i);
        }
    }

    template <class T>
    bool moved_too_far(const Field<T>& positions) const {
        for (std::size_t i = 0; i < made_at_.size(); ++i) {
            if (!(farthest_lane2(positions, i) <= allowed_ * allowed_)) return true;
        }
        return false;
    }

    /// Largest squared distance over the lanes of a particle from its position when the lists were made.
    template <class T>
    double farthest_lane2(const Field<T>& positions, std::size_t i) const {
        double farthest = 0;
        for (std::size_t lane = 0; lane < lanes_of<T>; ++lane) {
            const Vec3 moved = position(positions, i, lane) - made_at_[i];
            const double distance2 = dot(moved, moved);
            if (!(distance2 <= farthest)) farthest = distance2;
        }
        return farthest;
    }

    /// Largest distance of a lane from the position at which the lists were made.
    template <class T>
    double spread(const Field<T>& positions) const {
        double farthest2 = 0;
        for (std::size_t i = 0; i < made_at_.size(); ++i) farthest2 = std::max(farthest2, farthest_lane2(positions, i));
        return std::sqrt(farthest2);
    }

    /// Cells along an axis.
    struct Axis {
        double period = 0;
        double cell = 1;          ///< side of a cell
        std::uint64_t cells = 0;  ///< their number in the period

        void divide(double reach);
        std::uint64_t coordinate(double position) const;
        /// The coordinate of a cell this number of cells away.
        std::uint64_t beside(std::uint64_t coordinate, int number) const;
        double nearest_image(double d) const;
    };

    void make_lists();
    void append_neighbours(std::size_t i, std::span<const Placed> placed);
    std::uint64_t key(Vec3 position) const;
    Vec3 nearest_image(Vec3 d) const;

    double cutoff_;
    Axis x_, y_, z_;
    double skin_;
    double allowed_;  ///< largest allowed motion of a particle: half the skin minus a margin for rounding
    double reach_;
    std::vector<Vec3> made_at_;
    std::vector<std::uint32_t> list_;
    std::vector<std::size_t> begin_;
};

}  // namespace steplab
