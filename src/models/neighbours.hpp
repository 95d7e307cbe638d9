#pragma once

#include "core/field.hpp"
#include "core/vec3.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace steplab {

/// For each particle the others within reach, in the order of their indices (a Verlet list; Verlet, Phys. Rev. 159
/// (1967) 98). Reach is the cut-off and a skin, so that the list stays right until particles have moved half the skin.
class Neighbours {
public:
    explicit Neighbours(double cutoff) : skin_(0.15 * cutoff), reach_(cutoff + skin_) {}

    /// Renews the lists if a particle has moved too far since they were made.
    template <class T>
    void follow(const Field<T>& positions) {
        if (made_at_.size() == positions.count() && !moved_too_far(positions)) return;
        made_at_.resize(positions.count());
        for (std::size_t i = 0; i < made_at_.size(); ++i) made_at_[i] = positions.at(i);
        make_lists();
    }

    std::span<const std::uint32_t> of(std::size_t i) const {
        return {list_.data() + begin_[i], list_.data() + begin_[i + 1]};
    }

private:
    /// Particle `index` in the cell with this key; keys of cells that follow each other in z are consecutive.
    struct Placed {
        std::uint64_t cell;
        std::uint32_t index;
    };

    template <class T>
    bool moved_too_far(const Field<T>& positions) const {
        const double allowed = 0.45 * skin_;  // half the skin less what rounding may hide
        for (std::size_t i = 0; i < made_at_.size(); ++i) {
            const Vec3 moved = positions.at(i) - made_at_[i];
            if (!(dot(moved, moved) <= allowed * allowed)) return true;
        }
        return false;
    }

    void make_lists();
    void append_neighbours(std::size_t i, std::span<const Placed> placed);

    double skin_;
    double reach_;
    std::vector<Vec3> made_at_;
    std::vector<std::uint32_t> list_;
    std::vector<std::size_t> begin_;
};

}  // namespace steplab
