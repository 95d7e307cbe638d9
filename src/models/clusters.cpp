#include "models/clusters.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

namespace steplab {

namespace {

/// Columns along an axis that a key can tell apart; whoever is farther out shares the outermost column.
constexpr std::uint32_t most_columns = 1 << 16;
/// In a column of their own: particles that are nowhere.
constexpr std::uint64_t nowhere = std::numeric_limits<std::uint64_t>::max();

bool somewhere(Vec3 p) {
    constexpr double most = std::numeric_limits<float>::max();
    return std::abs(p.x) < most && std::abs(p.y) < most && std::abs(p.z) < most;
}

/// Whole numbers in the order of the numbers.
std::uint32_t ordered(float number) {
    const auto bits = std::bit_cast<std::uint32_t>(number);
    return bits >> 31 ? ~bits : bits | 0x80000000U;
}

/// The nearest floats on either side, monotonic in the number.
float below(double number) { return static_cast<float>(number) - std::abs(static_cast<float>(number)) * 0x1p-23F; }
float above(double number) { return static_cast<float>(number) + std::abs(static_cast<float>(number)) * 0x1p-23F; }

}  // namespace

void Clusters::make(const Field<double>& positions, double reach, double period) {
    reach_ = reach;
    period_ = period;
    choose_columns(positions);
    sort(positions);
    form_clusters(positions);
    list_pairs();
}

/// As wide as a cube that holds a cluster; where particles are few, or crowd together, as pairs ask for.
void Clusters::choose_columns(const Field<double>& positions) {
    double volume = period_ * period_ * period_;
    if (period_ == 0) {
        constexpr double most = std::numeric_limits<double>::max();
        Vec3 low{most, most, most}, high{-most, -most, -most};
        for (std::size_t i = 0; i < positions.count(); ++i) {
            const Vec3 p = positions.at(i);
            if (!somewhere(p)) continue;
            low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
            high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
        }
        volume = std::max(0.0, high.x - low.x) * std::max(0.0, high.y - low.y) * std::max(0.0, high.z - low.z);
    }
    const double particles = static_cast<double>(std::max<std::size_t>(1, positions.count()));
    width_ = std::clamp(std::cbrt(static_cast<double>(size) * volume / particles), reach_ / 4, reach_);
    if (period_ == 0) return;
    columns_a_row_ = static_cast<std::uint32_t>(std::clamp(std::floor(period_ / width_), 1.0, double{most_columns}));
    width_ = period_ / columns_a_row_;
}

std::uint32_t Clusters::column_at(double position) const {
    const double column = std::floor((position + period_ / 2) / width_);
    if (period_ > 0) return static_cast<std::uint32_t>(std::clamp(column, 0.0, columns_a_row_ - 1.0));
    return static_cast<std::uint32_t>(std::clamp(column + 0.5 * most_columns, 0.0, most_columns - 2.0));
}

void Clusters::sort(const Field<double>& positions) {
    placed_.resize(positions.count());
    for (std::size_t i = 0; i < placed_.size(); ++i) {
        const Vec3 p = positions.at(i);
        std::uint64_t key = nowhere;
        if (somewhere(p)) {
            const std::uint64_t x = column_at(p.x), y = column_at(p.y);
            key = x << 48 | y << 32 | ordered(static_cast<float>(p.z));
        }
        placed_[i] = {key, static_cast<std::uint32_t>(i)};
    }
    std::sort(placed_.begin(), placed_.end(), [](const Placed& a, const Placed& b) {
        return a.key != b.key ? a.key < b.key : a.particle < b.particle;
    });
}

void Clusters::form_clusters(const Field<double>& positions) {
    constexpr float most = std::numeric_limits<float>::infinity();
    places_.resize(placed_.size());
    columns_.clear();
    bounds_.clear();
    for (std::size_t k = 0, slot = 0; k < placed_.size(); ++k) {
        const auto [key, particle] = placed_[k];
        const auto begin = static_cast<std::uint32_t>(bounds_.size());
        if (k == 0 || key >> 32 != placed_[k - 1].key >> 32) {
            columns_.push_back(
                {static_cast<std::uint32_t>(key >> 48), static_cast<std::uint32_t>(key >> 32 & 0xFFFF), begin, begin});
            slot = 0;
        }
        if (slot % size == 0) {
            bounds_.push_back({{most, most, most}, {-most, -most, -most}});
            ++columns_.back().end;
        }
        places_[particle] = static_cast<std::uint32_t>((bounds_.size() - 1) * size + slot++ % size);
        if (key == nowhere) continue;
        const Vec3 p = positions.at(particle);
        Bounds& bounds = bounds_.back();
        const std::array<double, 3> along{p.x, p.y, p.z};
        for (std::size_t axis = 0; axis < 3; ++axis) {
            bounds.low[axis] = std::min(bounds.low[axis], below(along[axis]));
            bounds.high[axis] = std::max(bounds.high[axis], above(along[axis]));
        }
    }
}

void Clusters::list_pairs() {
    others_.clear();
    begin_.assign(1, 0);
    for (const Column& column : columns_) {
        find_adjacent(column);
        for (std::uint32_t cluster = column.begin; cluster < column.end; ++cluster) {
            for (Adjacent& adjacent : adjacent_) append_others(cluster, adjacent);
            begin_.push_back(static_cast<std::uint32_t>(others_.size()));
        }
    }
}

/// Columns before this one have listed their pairs with it themselves.
void Clusters::find_adjacent(const Column& column) {
    adjacent_.clear();
    const int range = static_cast<int>(std::ceil(reach_ / width_));
    const int row = static_cast<int>(columns_a_row_);
    const auto in_period = [row](int& at) {
        if (row == 0) return 0;
        const int image = at < 0 ? -1 : at >= row ? 1 : 0;
        at -= image * row;
        return image;
    };
    for (int dx = -range; dx <= range; ++dx) {
        for (int dy = -range; dy <= range; ++dy) {
            int x = static_cast<int>(column.x) + dx, y = static_cast<int>(column.y) + dy;
            const int image_x = in_period(x), image_y = in_period(y);
            if (x < 0 || y < 0) continue;
            const auto before = [](const Column& a, const Column& b) { return a.x != b.x ? a.x < b.x : a.y < b.y; };
            const Column wanted{static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y), 0, 0};
            const auto found = std::lower_bound(columns_.begin(), columns_.end(), wanted, before);
            if (found == columns_.end() || found->x != wanted.x || found->y != wanted.y) continue;
            if (found->begin < column.begin) continue;
            adjacent_.push_back(
                {found->begin, found->end, image_x, image_y, {found->begin, found->begin, found->begin}});
        }
    }
}

/// The clusters of a column go from below upwards, and so do those they are within reach of.
void Clusters::append_others(std::uint32_t cluster, Adjacent& adjacent) {
    const Bounds bounds = bounds_[cluster];
    const auto period = static_cast<float>(period_), reach = static_cast<float>(reach_);
    for (int z = period_ > 0 ? -1 : 0; z <= (period_ > 0 ? 1 : 0); ++z) {
        const std::array<float, 3> shift{static_cast<float>(adjacent.x) * period,
                                         static_cast<float>(adjacent.y) * period, static_cast<float>(z) * period};
        // an image begins and ends half a period from its middle
        if (z != 0 && static_cast<float>(z) * (z < 0 ? bounds.low[2] : bounds.high[2]) + reach < period / 2) continue;
        const auto image = static_cast<std::uint32_t>(9 * (adjacent.x + 1) + 3 * (adjacent.y + 1) + z + 1);
        const int place = z + 1;
        std::uint32_t& first = adjacent.first[static_cast<std::size_t>(place)];
        while (first < adjacent.end && bounds_[first].high[2] + shift[2] < bounds.low[2] - reach) ++first;
        for (std::uint32_t other = first; other < adjacent.end; ++other) {
            if (bounds_[other].low[2] + shift[2] > bounds.high[2] + reach) break;
            const bool once = other > cluster || (other == cluster && image > own_image);
            if (once && within_reach(bounds, bounds_[other], shift)) others_.emplace_back(other, image);
        }
    }
}

bool Clusters::within_reach(const Bounds& a, const Bounds& b, const std::array<float, 3>& shift) const {
    float distance2 = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const float up = b.low[axis] + shift[axis] - a.high[axis], down = a.low[axis] - (b.high[axis] + shift[axis]);
        const float apart = std::max(std::max(up, down), 0.0F);
        distance2 += apart * apart;
    }
    return distance2 <= static_cast<float>(reach_ * reach_);
}

}  // namespace steplab
