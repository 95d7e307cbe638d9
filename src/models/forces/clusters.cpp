#include "models/forces/clusters.hpp"

#include "core/root.hpp"
#include "core/team.hpp"
#include "models/forces/cluster_pairs.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <iterator>
#include <limits>

namespace steplab {

namespace {

/// Number of columns along an axis that a key can represent; particles farther out share the outermost column.
constexpr std::uint32_t most_columns = 1 << 16;
/// From this number of clusters on, there is more than one slab.
constexpr std::size_t many_clusters = 1024;
/// The column of particles without a valid position.
constexpr std::uint64_t nowhere = std::numeric_limits<std::uint64_t>::max();

/// True if differences of such positions are finite in both precisions.
bool somewhere(Vec3 p) {
    constexpr double most = std::numeric_limits<float>::max() / 4;
    return std::abs(p.x) < most && std::abs(p.y) < most && std::abs(p.z) < most;
}

/// An integer that is monotonic in the number.
std::uint32_t ordered(float number) {
    const auto bits = std::bit_cast<std::uint32_t>(number);
    return bits >> 31 ? ~bits : bits | 0x80000000U;
}

/// Floats just below and above the number, monotonic in it.
float below(double number) { return static_cast<float>(number) - std::abs(static_cast<float>(number)) * 0x1p-23F; }
float above(double number) { return static_cast<float>(number) + std::abs(static_cast<float>(number)) * 0x1p-23F; }

}  // namespace

void Clusters::make(std::size_t particles, const Position& position, double reach, double period, Team& team) {
    reach_ = reach;
    period_ = period;
    choose_columns(particles, position);
    sort(particles, position, team);
    find_bounds(form_clusters(), position, team);
    form_slabs();
    std::vector<Placed>().swap(placed_);  // assigning {} would keep the memory
}

/// Columns are as wide as a cube that contains a cluster, but limited by the reach where particles are few or crowded.
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
    width_ = std::clamp(root(static_cast<double>(size) * volume / count, 3), reach_ / 4, reach_);
    width_ = std::max(width_, std::numeric_limits<double>::min());  // the reach may be flushed to zero
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

/// All particles in the order of their previous clusters: most of them stay near their place.
std::vector<std::uint32_t> Clusters::former_order(std::size_t particles) const {
    std::vector<std::uint32_t> order;
    order.reserve(particles);
    if (places_.size() != particles + spare) {
        for (std::size_t i = 0; i < particles; ++i) order.push_back(static_cast<std::uint32_t>(i));
        return order;
    }
    constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
    std::vector<std::uint32_t> at(count_ * size, none);
    for (std::size_t i = 0; i < particles; ++i) at[places_[i]] = static_cast<std::uint32_t>(i);
    std::copy_if(at.begin(), at.end(), std::back_inserter(order), [](std::uint32_t i) { return i != none; });
    return order;
}

/// Each member of the team sorts a part; then parts are merged in pairs.
void Clusters::sort(std::size_t particles, const Position& position, Team& team) {
    const std::vector<std::uint32_t> former = former_order(particles);
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
        for (std::size_t k = begin; k < end; ++k) placed_[k] = {key_at(position(former[k])), former[k]};
        std::sort(begin_of(member), begin_of(member + 1), before);
        for (std::size_t merged = 1; merged < team.members(); merged *= 2) {
            team.meet();
            if (member % (2 * merged) == 0)
                std::inplace_merge(begin_of(member), begin_of(member + merged), begin_of(member + 2 * merged), before);
        }
    });
}

/// Returns the index of the first sorted particle of each cluster, and at the end the number of particles.
std::vector<std::uint32_t> Clusters::form_clusters() {
    std::vector<std::uint32_t> firsts;
    places_.reserve(placed_.size() + spare);
    places_.resize(placed_.size());
    columns_.clear();
    for (std::size_t k = 0, slot = 0; k < placed_.size(); ++k, ++slot) {
        const auto [key, particle] = placed_[k];
        const auto begin = static_cast<std::uint32_t>(firsts.size());
        if (k == 0 || key >> 32 != placed_[k - 1].key >> 32) {
            columns_.push_back(
                {static_cast<std::uint32_t>(key >> 48), static_cast<std::uint32_t>(key >> 32 & 0xFFFF), begin, begin});
            slot = 0;
        }
        if (slot % size == 0) {
            firsts.push_back(static_cast<std::uint32_t>(k));
            ++columns_.back().end;
        }
        places_[particle] = static_cast<std::uint32_t>((firsts.size() - 1) * size + slot % size);
    }
    count_ = firsts.size();
    places_.insert(places_.end(), spare, static_cast<std::uint32_t>(count_ * size + size - 1));
    firsts.push_back(static_cast<std::uint32_t>(placed_.size()));
    return firsts;
}

void Clusters::find_bounds(std::span<const std::uint32_t> firsts, const Position& position, Team& team) {
    constexpr float outside = std::numeric_limits<float>::infinity();
    for (Bounds& along : bounds_) {
        along.low.assign(count_ + side_by_side, outside);
        along.high.assign(count_ + side_by_side, -outside);
    }
    team.run([&](std::size_t member) {
        const auto [begin, end] = team.part(count_, member);
        for (std::size_t cluster = begin; cluster < end; ++cluster) {
            for (std::size_t k = firsts[cluster]; k < firsts[cluster + 1]; ++k) {
                if (placed_[k].key != nowhere) include(cluster, position(placed_[k].particle));
            }
        }
    });
}

/// Extends the bounds of a cluster.
void Clusters::include(std::size_t cluster, Vec3 position) {
    const std::array<double, 3> along{position.x, position.y, position.z};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        float &low = bounds_[axis].low[cluster], &high = bounds_[axis].high[cluster];
        low = std::min(low, below(along[axis]));
        high = std::max(high, above(along[axis]));
    }
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

const Clusters::Column* Clusters::column(int x, int y) const {
    if (x < 0 || y < 0) return nullptr;
    const auto before = [](const Column& a, const Column& b) { return a.x != b.x ? a.x < b.x : a.y < b.y; };
    const Column wanted{static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y), 0, 0};
    const auto found = std::lower_bound(columns_.begin(), columns_.end(), wanted, before);
    return found == columns_.end() || found->x != wanted.x || found->y != wanted.y ? nullptr : &*found;
}

void each_near_distance2(std::size_t particles, const Clusters::Position& position, double cutoff, double period,
                         Team& team, const std::function<void(std::span<const double>)>& f) {
    Clusters clusters;
    clusters.make(particles, position, cutoff, period, team);
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    std::vector<Vec3> at(clusters.count() * Clusters::size, Vec3{none, none, none});
    for (std::size_t i = 0; i < particles; ++i) at[clusters.places()[i]] = position(i);
    std::vector<double> near;
    const auto emit = [&, cutoff2 = cutoff * cutoff](Vec3 own, std::size_t from, std::size_t to) {
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
        for (std::size_t a = first; a < end; ++a) emit(at[a], a + 1, end);
        for (const Clusters::Other other : others) {
            const auto along = [&](std::size_t axis) { return period * Clusters::periods(other.image(), axis); };
            const Vec3 shift{along(0), along(1), along(2)};
            const std::size_t begin = other.cluster() * Clusters::size;
            for (std::size_t a = first; a < end; ++a) emit(at[a] - shift, begin, begin + Clusters::size);
        }
        f(near);
    };
    ClusterPairs pairs(clusters);
    for (const Clusters::Slab& slab : clusters.slabs()) pairs.each(slab, look_at_all);
}

}  // namespace steplab
