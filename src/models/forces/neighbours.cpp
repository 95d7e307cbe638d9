#include "models/forces/neighbours.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace steplab {

namespace {

/// Number of cells along each axis that a key can represent; particles farther out share the outermost cell.
constexpr double farthest = 1 << 20;

std::uint64_t join(std::uint64_t x, std::uint64_t y, std::uint64_t z) { return (x << 42) | (y << 21) | z; }

}  // namespace

void Neighbours::Axis::divide(double reach) {
    cells = period > 0 ? static_cast<std::uint64_t>(std::clamp(std::floor(period / reach), 1.0, farthest)) : 0;
    cell = cells > 0 ? period / static_cast<double>(cells) : reach;
}

std::uint64_t Neighbours::Axis::coordinate(double position) const {
    const double at = std::floor(position / cell);
    if (cells == 0) {
        if (!(at + farthest > 1)) return 1;  // also if the position is not a number
        return static_cast<std::uint64_t>(std::min(at + farthest, 2 * farthest - 2));
    }
    const auto all = static_cast<double>(cells), within = at - all * std::floor(at / all);
    return within >= 0 && within < all ? static_cast<std::uint64_t>(within) : 0;
}

std::uint64_t Neighbours::Axis::beside(std::uint64_t coordinate, int number) const {
    const std::uint64_t at = coordinate + cells + static_cast<std::uint64_t>(static_cast<std::int64_t>(number));
    return cells == 0 ? at : at % cells;
}

double Neighbours::Axis::nearest_image(double d) const {
    return period == 0 || std::abs(d) <= period / 2 ? d : d - period * std::nearbyint(d / period);
}

std::uint64_t Neighbours::key(Vec3 position) const {
    return join(x_.coordinate(position.x), y_.coordinate(position.y), z_.coordinate(position.z));
}

Vec3 Neighbours::nearest_image(Vec3 d) const {
    return {x_.nearest_image(d.x), y_.nearest_image(d.y), z_.nearest_image(d.z)};
}

void Neighbours::make_lists() {
    for (Axis* const axis : {&x_, &y_, &z_}) axis->divide(reach_);
    std::vector<Placed> placed(made_at_.size());
    for (std::size_t i = 0; i < placed.size(); ++i) placed[i] = {key(made_at_[i]), static_cast<std::uint32_t>(i)};
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
    const std::uint64_t cx = x_.coordinate(here.x), cy = y_.coordinate(here.y), cz = z_.coordinate(here.z);
    std::array<std::uint64_t, 27> cells{};
    std::size_t count = 0;
    for (int x = -1; x <= 1; ++x) {
        for (int y = -1; y <= 1; ++y) {
            for (int z = -1; z <= 1; ++z) cells[count++] = join(x_.beside(cx, x), y_.beside(cy, y), z_.beside(cz, z));
        }
    }
    std::sort(cells.begin(), cells.end());
    const auto end = std::unique(cells.begin(), cells.end());  // in a small period they may coincide
    const auto before = [](Placed p, std::uint64_t cell) { return p.cell < cell; };
    for (auto cell = cells.begin(); cell != end; ++cell) {
        auto p = std::lower_bound(placed.begin(), placed.end(), *cell, before);
        for (; p != placed.end() && p->cell == *cell; ++p) {
            const Vec3 d = nearest_image(made_at_[p->index] - here);
            if (p->index != i && dot(d, d) <= reach_ * reach_) list_.push_back(p->index);
        }
    }
    std::sort(list_.begin() + static_cast<std::ptrdiff_t>(begin_.back()), list_.end());
}

}  // namespace steplab
