#pragma once

#include "core/field.hpp"
#include "core/force_layout.hpp"
#include "core/lanes.hpp"
#include "models/forces/composed_particles.hpp"
#include "models/forces/few_pairs.hpp"
#include "models/forces/pair_potential.hpp"

#include <algorithm>
#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace steplab {

/// All pairs of one set of particles, or of two, that are numbered through: the matrix of pairs row by row, a block of
/// a row at a time. Blocks are as long on every machine, so that sums have the same bits.
template <class T>
class PairRows {
public:
    /// Nothing where there is a cut-off, a box or displacements from a reference, or numbers or pairs are left out.
    static std::optional<PairRows> of(const ComposedPairs& pairs, const Composition& all) {
        const auto first = range_of(pairs.first), second = range_of(pairs.second);
        const bool open = all.box == Vec3{} && all.reference.empty() && !pairs.is_short_ranged();
        if (!open || !first || (!second && !pairs.second.empty())) return std::nullopt;
        PairRows rows(*first, second ? *second : *first, pairs.second.empty());
        const bool apart = rows.rows_.end <= rows.columns_.begin || rows.columns_.end <= rows.rows_.begin;
        if (!rows.within_ && !apart) return std::nullopt;
        const ComposedParticles<T> particles(std::make_shared<const Composition>(all));
        rows.expression_ = pairs.expression;
        rows.keep_properties(particles);
        if (rows.are_few()) rows.few_.emplace(rows.all(), particles, rows.turned_);
        return rows;
    }

    template <class Potential>
    void add(const Potential& potential, const Field<T>& u, Field<T>& a) const {
        if (few_) {
            auto factors = factors_of<typename FewPairs<T>::N>(potential);
            return few_->add(factors, u, a);
        }
        auto factors = factors_of<N>(potential);
        for (std::size_t i = rows_.begin; i < rows_.end; ++i) add_row(factors, u, a, i, columns_of(i));
    }

private:
    static constexpr std::size_t width = Field<T>::granule;
    using N = RegisterLanes<T, width>;

    struct Range {
        std::size_t begin = 0, end = 0;
    };

    /// Rows are the smaller set.
    PairRows(Range first, Range second, bool within)
        : rows_(first),
          columns_(second),
          within_(within),
          turned_(first.end - first.begin > second.end - second.begin) {
        if (turned_) std::swap(rows_, columns_);
    }

    static std::optional<Range> range_of(const std::vector<std::uint32_t>& particles) {
        if (particles.empty()) return std::nullopt;
        for (std::size_t k = 1; k < particles.size(); ++k) {
            if (particles[k] != particles[k - 1] + 1) return std::nullopt;
        }
        return Range{particles.front(), std::size_t(particles.back()) + 1};
    }

    Range columns_of(std::size_t i) const { return {within_ ? i + 1 : columns_.begin, columns_.end}; }

    /// Every row is of one block, and there are not many.
    bool are_few() const {
        const std::size_t rows = rows_.end - rows_.begin, columns = columns_.end - columns_.begin;
        const bool one_block = columns_.begin / width == (columns_.end - 1) / width;
        return one_block && (within_ ? rows * (rows - 1) / 2 : rows * columns) <= FewPairs<T>::most;
    }
    std::vector<typename FewPairs<T>::Row> all() const {
        std::vector<typename FewPairs<T>::Row> all;
        for (std::size_t i = rows_.begin; i < rows_.end; ++i) {
            const Range columns = columns_of(i);
            if (columns.begin < columns.end) all.push_back({i, columns.begin, columns.end});
        }
        return all;
    }

    void keep_properties(const ComposedParticles<T>& particles) {
        properties_ = Field<T>(particles.count());
        for (std::size_t i = 0; i < particles.count(); ++i) {
            properties_.x()[i] = particles.mass(i);
            properties_.y()[i] = particles.inverse_mass(i);
            properties_.z()[i] = particles.charge(i);
        }
    }

    template <class Number, class Potential>
    auto factors_of(const Potential& potential) const {
        if constexpr (std::same_as<Potential, ExpressionPotential<T>>) {
            return ExpressionFactors<T, Number>(expression_->force);
        } else {
            return [&potential](const Number& distance2, const PairProperties<Number>& pair)
                __attribute__((always_inline)) {
                return potential.factor(distance2, pair);
            };
        }
    }

    template <class Factors>
    void add_row(Factors& factors, const Field<T>& u, Field<T>& a, std::size_t i, Range columns) const {
        const Vector<N> here{N(u.x()[i]), N(u.y()[i]), N(u.z()[i])};
        Vector<N> sum{N(T(0)), N(T(0)), N(T(0))};
        for (std::size_t j = columns.begin / width * width; j < columns.end; j += width) {
            const Vector<N> d{N::load(u.x() + j) - here.x, N::load(u.y() + j) - here.y, N::load(u.z() + j) - here.z};
            N distance2 = d.x * d.x + d.y * d.y + d.z * d.z;
            if (j < columns.begin || j + width > columns.end) distance2 = inside(distance2, j, columns);
            const auto apart = distance2 > N(T(0));
            const N factor = where(apart, factors(where(apart, distance2, N(T(1))), pair_of(i, j)), N(T(0)));
            const Vector<N> push = factor * d;
            const N inverse = N::load(properties_.y() + j);
            sum = sum + push;
            (N::load(a.x() + j) + inverse * push.x).store(a.x() + j);
            (N::load(a.y() + j) + inverse * push.y).store(a.y() + j);
            (N::load(a.z() + j) + inverse * push.z).store(a.z() + j);
        }
        a.x()[i] -= properties_.y()[i] * total(sum.x);
        a.y()[i] -= properties_.y()[i] * total(sum.y);
        a.z()[i] -= properties_.y()[i] * total(sum.z);
    }

    /// 0 where the block from j on reaches beyond the columns.
    static N inside(const N& distance2, std::size_t j, Range columns) {
        return N::each([&](std::size_t lane) {
            return j + lane < columns.begin || j + lane >= columns.end ? T(0) : distance2[lane];
        });
    }

    PairProperties<N> pair_of(std::size_t i, std::size_t j) const {
        const N mass = N::load(properties_.x() + j), charge = N::load(properties_.z() + j);
        const N own_mass(properties_.x()[i]), own_charge(properties_.z()[i]);
        if (turned_) return {mass, own_mass, charge, own_charge};
        return {own_mass, mass, own_charge, charge};
    }

    static T total(const N& lanes) {
        T sum = lanes[0];
        for (std::size_t lane = 1; lane < width; ++lane) sum += lanes[lane];
        return sum;
    }

    Range rows_, columns_;
    bool within_, turned_;
    std::optional<FewPairs<T>> few_;
    std::shared_ptr<const ExpressionForce> expression_;
    Field<T> properties_;  ///< of each particle: mass, inverse mass, charge
};

}  // namespace steplab
