#include "models/neighbours.hpp"

#include <algorithm>
#include <cmath>

namespace steplab {

namespace {

/// Cells along each axis that a key can tell apart; whoever is farther out shares the outermost cell.
constexpr double farthest = 1 << 20;

std::uint64_t coordinate(double position, double size) {
    const double cell = std::floor(position / size) + farthest;
    if (!(cell > 1)) return 1;  // also where the position is not a number
    return static_cast<std::uint64_t>(std::min(cell, 2 * farthest - 2));
}

std::uint64_t key(std::uint64_t x, std::uint64_t y, std::uint64_t z) { return (x << 42) | (y << 21) | z; }

}  // namespace

void Neighbours::make_lists() {
    std::vector<Placed> placed(made_at_.size());
    for (std::size_t i = 0; i < placed.size(); ++i) {
        const Vec3 p = made_at_[i];
        placed[i] = {key(coordinate(p.x, reach_), coordinate(p.y, reach_), coordinate(p.z, reach_)),
                     static_cast<std::uint32_t>(i)};
    }
    std::sort(placed.begin(), placed.end(), [](Placed a, Placed b) { return a.cell < b.cell; });
    list_.clear();
    begin_.assign(1, 0);
    for (std::size_t i = 0; i < made_at_.size(); ++i) {
        append_neighbours(i, placed);
        begin_.push_back(list_.size());
    }
}

void Neighbours::append_neighbours(std::size_t i, std::span<const Placed> placed) {
    const Vec3 here = made_at_[i];
    const std::uint64_t cx = coordinate(here.x, reach_), cy = coordinate(here.y, reach_),
                        cz = coordinate(here.z, reach_);
    const auto before = [](Placed p, std::uint64_t cell) { return p.cell < cell; };
    for (std::uint64_t x = cx - 1; x <= cx + 1; ++x) {
        for (std::uint64_t y = cy - 1; y <= cy + 1; ++y) {
            auto p = std::lower_bound(placed.begin(), placed.end(), key(x, y, cz - 1), before);
            for (; p != placed.end() && p->cell <= key(x, y, cz + 1); ++p) {
                const Vec3 d = made_at_[p->index] - here;
                if (p->index != i && dot(d, d) <= reach_ * reach_) list_.push_back(p->index);
            }
        }
    }
    std::sort(list_.begin() + static_cast<std::ptrdiff_t>(begin_.back()), list_.end());
}

}  // namespace steplab
