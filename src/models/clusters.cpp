#include "models/clusters.hpp"

#include "core/lanes.hpp"
#include "core/team.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

namespace steplab {

namespace {

/// Columns along an axis that a key can tell apart; whoever is farther out shares the outermost column.
constexpr std::uint32_t most_columns = 1 << 16;
/// Clusters whose distances are computed side by side.
constexpr std::uint32_t side_by_side = 8;
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

void Clusters::make(std::size_t particles, const Position& position, double reach, double period, Team& team) {
    reach_ = reach;
    period_ = period;
    choose_columns(particles, position);
    sort(particles, position, team);
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

std::uint64_t Clusters::key_at(Vec3 position) const {
    if (!somewhere(position)) return nowhere;
    const std::uint64_t x = column_at(position.x), y = column_at(position.y);
    return x << 48 | y << 32 | ordered(static_cast<float>(position.z));
}

/// Each of the team sorts a part; then parts are merged two by two.
void Clusters::sort(std::size_t particles, const Position& position, Team& team) {
    placed_.resize(particles);
    const auto begin_of = [&](std::size_t member) {
        const std::size_t begin = member < team.members() ? team.part(particles, member).begin : particles;
        return placed_.begin() + static_cast<std::ptrdiff_t>(begin);
    };
    const auto before = [](const Placed& a, const Placed& b) {
        return a.key != b.key ? a.key < b.key : a.particle < b.particle;
    };
    team.run([&](std::size_t member) {
        const auto [begin, end] = team.part(particles, member);
        for (std::size_t i = begin; i < end; ++i) placed_[i] = {key_at(position(i)), static_cast<std::uint32_t>(i)};
        std::sort(begin_of(member), begin_of(member + 1), before);
        for (std::size_t merged = 1; merged < team.members(); merged *= 2) {
            team.meet();
            if (member % (2 * merged) == 0)
                std::inplace_merge(begin_of(member), begin_of(member + merged), begin_of(member + 2 * merged), before);
        }
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
            const Box box = box_of(cluster);
            for (Adjacent& adjacent : columns) append_others(box, adjacent, others);
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

Clusters::Box Clusters::box_of(std::uint32_t cluster) const {
    Box box{cluster, {}, {}, 0, 0};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        box.low[axis] = bounds_[axis].low[cluster];
        box.high[axis] = bounds_[axis].high[cluster];
    }
    if (period_ == 0) return box;
    // an image begins and ends half a period from its middle
    const auto half = static_cast<float>(period_) / 2, reach = static_cast<float>(reach_);
    box.first_z = reach - box.low[2] >= half ? -1 : 0;
    box.last_z = box.high[2] + reach >= half ? 1 : 0;
    return box;
}

/// The clusters of a column go from below upwards, and so do those they are within reach of.
void Clusters::append_others(const Box& box, Adjacent& adjacent, Others& others) const {
    const float* const high = bounds_[2].high.data();
    const float lowest = box.low[2] - static_cast<float>(reach_);
    for (int z = box.first_z; z <= box.last_z; ++z) {
        const float shift = static_cast<float>(z) * static_cast<float>(period_);
        const int place = z + 1;
        std::uint32_t& first = adjacent.first[static_cast<std::size_t>(place)];
        while (first < adjacent.end && high[first] + shift < lowest) ++first;
        const auto image = static_cast<std::uint32_t>(9 * (adjacent.x + 1) + 3 * (adjacent.y + 1) + z + 1);
        // each pair once
        const std::uint32_t from = std::max(first, image > own_image ? box.cluster : box.cluster + 1);
        append_within_reach(moved_back(box, image), from, adjacent.end, image, others);
    }
}

/// What an image is to the cluster, its original is to this.
Clusters::Box Clusters::moved_back(Box box, std::uint32_t image) const {
    if (image == own_image) return box;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const float shift = static_cast<float>(periods(image, axis)) * static_cast<float>(period_);
        box.low[axis] -= shift;
        box.high[axis] -= shift;
    }
    return box;
}

/// Of a column's clusters. Without branches, as the next of them is near as often as not.
void Clusters::append_within_reach(const Box& box, std::uint32_t from, std::uint32_t to, std::uint32_t image,
                                   Others& others) const {
    using Lanes = RegisterLanes<float, side_by_side>;
    const float reach2 = static_cast<float>(reach_ * reach_), highest = box.high[2] + static_cast<float>(reach_);
    for (std::uint32_t other = from; other < to && bounds_[2].low[other] <= highest; other += side_by_side) {
        Lanes distance2(0.0F);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const Lanes up = Lanes::load_anywhere(bounds_[axis].low.data() + other) - Lanes(box.high[axis]);
            const Lanes down = Lanes(box.low[axis]) - Lanes::load_anywhere(bounds_[axis].high.data() + other);
            const Lanes apart = where(up < down, down, up), none(0.0F);
            const Lanes gap = where(none < apart, apart, none);
            distance2 += gap * gap;
        }
        alignas(64) std::array<float, side_by_side> squares;
        distance2.store(squares.data());
        std::size_t end = others.size();
        others.resize(end + side_by_side);
        for (std::uint32_t lane = 0; lane < side_by_side; ++lane) {
            others[end] = Other(other + lane, image);
            end += squares[lane] <= reach2 && other + lane < to ? 1 : 0;
        }
        others.resize(end);
    }
}

void each_near_distance2(std::size_t particles, const Clusters::Position& position, double cutoff, double period,
                         Team& team, const std::function<void(std::span<const double>)>& f) {
    Clusters clusters;
    clusters.make(particles, position, cutoff, period, team);
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    std::vector<Vec3> at(clusters.count() * Clusters::size, Vec3{none, none, none});
    for (std::size_t i = 0; i < particles; ++i) at[clusters.places()[i]] = position(i);
    std::vector<double> near;
    const auto look = [&, cutoff2 = cutoff * cutoff](Vec3 own, std::size_t from, std::size_t to) {
        std::size_t end = near.size();
        near.resize(end + Clusters::size);
        for (std::size_t b = from; b < to; ++b) {
            const Vec3 d = at[b] - own;
            near[end] = dot(d, d);
            end += near[end] < cutoff2 ? 1 : 0;
        }
        near.resize(end);
    };
    const auto look_at_all = [&](std::uint32_t cluster, std::span<const Clusters::Other> others) {
        const std::size_t first = cluster * Clusters::size, end = first + Clusters::size;
        near.clear();
        for (std::size_t a = first; a < end; ++a) look(at[a], a + 1, end);
        for (const Clusters::Other other : others) {
            const auto along = [&](std::size_t axis) { return period * Clusters::periods(other.image(), axis); };
            const Vec3 shift{along(0), along(1), along(2)};
            const std::size_t begin = other.cluster() * Clusters::size;
            for (std::size_t a = first; a < end; ++a) look(at[a] - shift, begin, begin + Clusters::size);
        }
        f(near);
    };
    for (const Clusters::Slab& slab : clusters.slabs()) clusters.each(slab, look_at_all);
}

}  // namespace steplab
