#include "models/clusters.hpp"

#include "core/lanes.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

namespace steplab {

namespace {

/// Columns along an axis that a key can tell apart; whoever is farther out shares the outermost column.
constexpr std::uint32_t most_columns = 1 << 16;
/// Clusters whose distances are computed side by side.
constexpr std::uint32_t side_by_side = 4;
/// From which on there is more than one slab.
constexpr std::size_t many_clusters = 1024;
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

void Clusters::make(std::size_t particles, const Position& position, double reach, double period) {
    reach_ = reach;
    period_ = period;
    choose_columns(particles, position);
    sort(particles, position);
    form_clusters(position);
    form_slabs();
    placed_ = {};
}

/// As wide as a cube that holds a cluster; where particles are few, or crowd together, as pairs ask for.
void Clusters::choose_columns(std::size_t particles, const Position& position) {
    double volume = period_ * period_ * period_;
    if (period_ == 0) {
        constexpr double largest = std::numeric_limits<double>::max();
        Vec3 low{largest, largest, largest}, high{-largest, -largest, -largest};
        for (std::size_t i = 0; i < particles; ++i) {
            const Vec3 p = position(i);
            if (!somewhere(p)) continue;
            low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
            high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
        }
        volume = std::max(0.0, high.x - low.x) * std::max(0.0, high.y - low.y) * std::max(0.0, high.z - low.z);
    }
    const double count = static_cast<double>(std::max<std::size_t>(1, particles));
    width_ = std::clamp(std::cbrt(static_cast<double>(size) * volume / count), reach_ / 4, reach_);
    width_ = std::max(width_, std::numeric_limits<double>::min());  // a reach may be flushed to zero
    if (period_ == 0) return;
    columns_a_row_ = static_cast<std::uint32_t>(std::clamp(std::floor(period_ / width_), 1.0, double{most_columns}));
    width_ = period_ / columns_a_row_;
}

std::uint32_t Clusters::column_at(double position) const {
    const double column = std::floor((position + period_ / 2) / width_);
    if (period_ > 0) return static_cast<std::uint32_t>(std::clamp(column, 0.0, columns_a_row_ - 1.0));
    return static_cast<std::uint32_t>(std::clamp(column + 0.5 * most_columns, 0.0, most_columns - 2.0));
}

void Clusters::sort(std::size_t particles, const Position& position) {
    placed_.resize(particles);
    for (std::size_t i = 0; i < placed_.size(); ++i) {
        const Vec3 p = position(i);
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

void Clusters::add_cluster() {
    constexpr float outside = std::numeric_limits<float>::infinity();
    for (Bounds& along : bounds_) {
        along.low.push_back(outside);
        along.high.push_back(-outside);
    }
}

void Clusters::form_clusters(const Position& position) {
    places_.resize(placed_.size());
    columns_.clear();
    for (Bounds& along : bounds_) along.low.clear(), along.high.clear();
    count_ = 0;
    for (std::size_t k = 0, slot = 0; k < placed_.size(); ++k) {
        const auto [key, particle] = placed_[k];
        const auto begin = static_cast<std::uint32_t>(count_);
        if (k == 0 || key >> 32 != placed_[k - 1].key >> 32) {
            columns_.push_back(
                {static_cast<std::uint32_t>(key >> 48), static_cast<std::uint32_t>(key >> 32 & 0xFFFF), begin, begin});
            slot = 0;
        }
        if (slot % size == 0) {
            add_cluster();
            ++count_;
            ++columns_.back().end;
        }
        places_[particle] = static_cast<std::uint32_t>((count_ - 1) * size + slot++ % size);
        if (key == nowhere) continue;
        const Vec3 p = position(particle);
        const std::array<double, 3> along{p.x, p.y, p.z};
        for (std::size_t axis = 0; axis < 3; ++axis) {
            float &low = bounds_[axis].low.back(), &high = bounds_[axis].high.back();
            low = std::min(low, below(along[axis]));
            high = std::max(high, above(along[axis]));
        }
    }
    for (std::size_t beyond = 0; beyond < side_by_side; ++beyond) add_cluster();
}

std::uint32_t Clusters::range() const { return static_cast<std::uint32_t>(std::ceil(reach_ / width_)); }

void Clusters::form_slabs() {
    slabs_.clear();
    for (std::size_t k = 0; k < columns_.size(); ++k) {
        const Column& column = columns_[k];
        const bool next =
            k > 0 && count_ >= many_clusters && column.x - columns_[slabs_.back().first_column].x >= range();
        if (k == 0 || next) slabs_.push_back({column.begin, column.begin, k, k});
        slabs_.back().end = column.end;
        slabs_.back().end_column = k + 1;
    }
}

void Clusters::each(const Slab& slab, const std::function<void(std::uint32_t, std::span<const Other>)>& f) const {
    Others others;
    for (std::size_t k = slab.first_column; k < slab.end_column; ++k) {
        auto columns = adjacent(columns_[k]);
        for (std::uint32_t cluster = columns_[k].begin; cluster < columns_[k].end; ++cluster) {
            others.clear();
            for (Adjacent& adjacent : columns) append_others(cluster, adjacent, others);
            f(cluster, others);
        }
    }
}

/// Columns before this one have listed their pairs with it themselves.
std::vector<Clusters::Adjacent> Clusters::adjacent(const Column& column) const {
    std::vector<Adjacent> result;
    const int around = static_cast<int>(range());
    const int row = static_cast<int>(columns_a_row_);
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
            if (x < 0 || y < 0) continue;
            const auto before = [](const Column& a, const Column& b) { return a.x != b.x ? a.x < b.x : a.y < b.y; };
            const Column wanted{static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y), 0, 0};
            const auto found = std::lower_bound(columns_.begin(), columns_.end(), wanted, before);
            if (found == columns_.end() || found->x != wanted.x || found->y != wanted.y) continue;
            if (found->begin < column.begin) continue;
            result.push_back({found->begin, found->end, image_x, image_y, {found->begin, found->begin, found->begin}});
        }
    }
    return result;
}

/// The clusters of a column go from below upwards, and so do those they are within reach of.
void Clusters::append_others(std::uint32_t cluster, Adjacent& adjacent, Others& others) const {
    const Bounds& up = bounds_[2];
    const auto period = static_cast<float>(period_), reach = static_cast<float>(reach_);
    const float low = up.low[cluster], high = up.high[cluster];
    for (int z = period_ > 0 ? -1 : 0; z <= (period_ > 0 ? 1 : 0); ++z) {
        const float shift = static_cast<float>(z) * period;
        // an image begins and ends half a period from its middle
        if (z != 0 && static_cast<float>(z) * (z < 0 ? low : high) + reach < period / 2) continue;
        const int place = z + 1;
        std::uint32_t& first = adjacent.first[static_cast<std::size_t>(place)];
        while (first < adjacent.end && up.high[first] + shift < low - reach) ++first;
        const auto image = static_cast<std::uint32_t>(9 * (adjacent.x + 1) + 3 * (adjacent.y + 1) + z + 1);
        // each pair once
        const std::uint32_t from = std::max(first, image > own_image ? cluster : cluster + 1);
        append_within_reach(cluster, from, adjacent.end, image, others);
    }
}

/// Of a column's clusters.
void Clusters::append_within_reach(std::uint32_t cluster, std::uint32_t from, std::uint32_t to, std::uint32_t image,
                                   Others& others) const {
    using Lanes = RegisterLanes<float, side_by_side>;
    const auto shift = [&](std::size_t axis) {
        return static_cast<float>(periods(image, axis)) * static_cast<float>(period_);
    };
    const std::array<float, 3> shifts{shift(0), shift(1), shift(2)};
    const float reach2 = static_cast<float>(reach_ * reach_);
    const float highest = bounds_[2].high[cluster] + static_cast<float>(reach_);
    for (std::uint32_t other = from; other < to && bounds_[2].low[other] + shifts[2] <= highest;
         other += side_by_side) {
        Lanes distance2(0.0F);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const auto& [low, high] = bounds_[axis];
            const Lanes up = Lanes::load_anywhere(low.data() + other) + Lanes(shifts[axis] - high[cluster]);
            const Lanes down = Lanes(low[cluster] - shifts[axis]) - Lanes::load_anywhere(high.data() + other);
            const Lanes apart = where(up < down, down, up), none(0.0F);
            distance2 += where(none < apart, apart * apart, none);
        }
        const auto far = Lanes(reach2) < distance2;
        for (std::uint32_t lane = 0; lane < side_by_side && other + lane < to; ++lane) {
            if (!far[lane]) others.emplace_back(other + lane, image);
        }
    }
}

void each_near_distance2(std::size_t particles, const Clusters::Position& position, double cutoff, double period,
                         const std::function<void(double)>& f) {
    Clusters clusters;
    clusters.make(particles, position, cutoff, period);
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    std::vector<Vec3> at(clusters.count() * Clusters::size, Vec3{none, none, none});
    for (std::size_t i = 0; i < particles; ++i) at[clusters.places()[i]] = position(i);
    const auto look = [&](std::size_t a, std::size_t b, Vec3 shift) {
        const Vec3 d = at[b] + shift - at[a];
        if (dot(d, d) < cutoff * cutoff) f(dot(d, d));
    };
    const auto look_at_all = [&](std::uint32_t cluster, std::span<const Clusters::Other> others) {
        const std::size_t first = cluster * Clusters::size, end = first + Clusters::size;
        for (std::size_t a = first; a < end; ++a) {
            for (std::size_t b = a + 1; b < end; ++b) look(a, b, {});
        }
        for (const Clusters::Other other : others) {
            const auto along = [&](std::size_t axis) { return period * Clusters::periods(other.image(), axis); };
            const Vec3 shift{along(0), along(1), along(2)};
            for (std::size_t a = first; a < end; ++a) {
                for (std::size_t b = 0; b < Clusters::size; ++b) look(a, other.cluster() * Clusters::size + b, shift);
            }
        }
    };
    for (const Clusters::Slab& slab : clusters.slabs()) clusters.each(slab, look_at_all);
}

}  // namespace steplab
