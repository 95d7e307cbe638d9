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

std::uint64_t Neighbours::coordinate(double position) const {
    const double cell = std::floor(position / cell_);
    if (cells_ == 0) {
        if (!(cell + farthest > 1)) return 1;  // also if the position is not a number
        return static_cast<std::uint64_t>(std::min(cell + farthest, 2 * farthest - 2));
    }
    const auto cells = static_cast<double>(cells_), within = cell - cells * std::floor(cell / cells);
    return within >= 0 && within < cells ? static_cast<std::uint64_t>(within) : 0;
}

/// The coordinate of a cell this number of cells away.
std::uint64_t Neighbours::beside(std::uint64_t coordinate, int cells) const {
    const std::uint64_t at = coordinate + cells_ + static_cast<std::uint64_t>(static_cast<std::int64_t>(cells));
    return cells_ == 0 ? at : at % cells_;
}

std::uint64_t Neighbours::key(Vec3 position) const {
    return join(coordinate(position.x), coordinate(position.y), coordinate(position.z));
}

Vec3 Neighbours::nearest_image(Vec3 d) const {
    if (period_ == 0) return d;
    const auto along = [this](double x) { return x - period_ * std::nearbyint(x / period_); };
    return {along(d.x), along(d.y), along(d.z)};
}

void Neighbours::make_lists() {
    cells_ = period_ > 0 ? static_cast<std::uint64_t>(std::clamp(std::floor(period_ / reach_), 1.0, farthest)) : 0;
    cell_ = cells_ > 0 ? period_ / static_cast<double>(cells_) : reach_;
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
    const std::uint64_t cx = coordinate(here.x), cy = coordinate(here.y), cz = coordinate(here.z);
    std::array<std::uint64_t, 27> cells{};
    std::size_t count = 0;
    for (int x = -1; x <= 1; ++x) {
        for (int y = -1; y <= 1; ++y) {
            for (int z = -1; z <= 1; ++z) cells[count++] = join(beside(cx, x), beside(cy, y), beside(cz, z));
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
