#pragma once

#include "core/field.hpp"
#include "core/force_layout.hpp"
#include "core/lanes.hpp"
#include "core/vector.hpp"
#include "models/forces/composed_particles.hpp"

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace steplab {

/// All pairs of few particles, a register of pairs at a time: in a row of their matrix most lanes would be empty. What
/// they add up to has the same bits as in rows of one block (composed_rows.hpp): each sum is taken in the same order.
template <class T>
class FewPairs {
public:
    using N = Lanes<T>;
    static constexpr std::size_t most = 128;

    /// A particle and its partners, which are numbered through.
    struct Row {
        std::size_t particle, begin, end;
    };

    /// `turned`: the partners come first in what a potential is told of a pair.
    FewPairs(std::vector<Row> rows, const ComposedParticles<T>& particles, bool turned) : rows_(std::move(rows)) {
        for (std::size_t i = 0; i < particles.count(); ++i) inverse_masses_.push_back(particles.inverse_mass(i));
        for (const Row& row : rows_) {
            for (std::size_t j = row.begin; j < row.end; ++j, ++count_)
                keep(turned ? particles.properties(j, row.particle) : particles.properties(row.particle, j));
        }
        while (properties_[0].size() % N::count != 0) keep({});
    }

    /// `factors`: of squared distances and properties.
    template <class Factors>
    void add(Factors& factors, const Field<T>& u, Field<T>& a) const {
        Pulls pulls;
        find_differences(u, pulls);
        for (std::size_t k = 0; k < count_; k += N::count) {
            const Vector<N> d{N::load(pulls.x.data() + k), N::load(pulls.y.data() + k), N::load(pulls.z.data() + k)};
            const N distance2 = d.x * d.x + d.y * d.y + d.z * d.z;
            const auto apart = distance2 > N(T(0));
            const N factor = where(apart, factors(where(apart, distance2, N(T(1))), pairs_from(k)), N(T(0)));
            (factor * d.x).store(pulls.x.data() + k);
            (factor * d.y).store(pulls.y.data() + k);
            (factor * d.z).store(pulls.z.data() + k);
        }
        add_pulls(pulls, a);
    }

private:
    using Numbers = std::vector<T, CacheLineAllocator<T>>;

    /// Of each pair; the differences of displacements in their place at first.
    struct Pulls {
        alignas(64) std::array<T, most> x, y, z;
    };

    void keep(const PairProperties<T>& pair) {
        properties_[0].push_back(pair.first_mass), properties_[1].push_back(pair.second_mass);
        properties_[2].push_back(pair.first_charge), properties_[3].push_back(pair.second_charge);
    }
    PairProperties<N> pairs_from(std::size_t k) const {
        const auto of = [k](const Numbers& numbers) { return N::load(numbers.data() + k); };
        return {of(properties_[0]), of(properties_[1]), of(properties_[2]), of(properties_[3])};
    }

    void find_differences(const Field<T>& u, Pulls& d) const {
        std::size_t k = 0;
        for (const Row& row : rows_) {
            const std::size_t i = row.particle;
            for (std::size_t j = row.begin; j < row.end; ++j, ++k) {
                d.x[k] = u.x()[j] - u.x()[i];
                d.y[k] = u.y()[j] - u.y()[i];
                d.z[k] = u.z()[j] - u.z()[i];
            }
        }
        for (; k % N::count != 0; ++k) d.x[k] = d.y[k] = d.z[k] = T(0);
    }

    void add_pulls(const Pulls& pulls, Field<T>& a) const {
        T *const x = a.x(), *const y = a.y(), *const z = a.z();
        std::size_t k = 0;
        for (const Row& row : rows_) {
            Vector<T> sum{T(0), T(0), T(0)};
            for (std::size_t j = row.begin; j < row.end; ++j, ++k) {
                const T inverse = inverse_masses_[j];
                sum.x += pulls.x[k], x[j] += inverse * pulls.x[k];
                sum.y += pulls.y[k], y[j] += inverse * pulls.y[k];
                sum.z += pulls.z[k], z[j] += inverse * pulls.z[k];
            }
            const std::size_t i = row.particle;
            const T inverse = inverse_masses_[i];
            x[i] -= inverse * sum.x;
            y[i] -= inverse * sum.y;
            z[i] -= inverse * sum.z;
        }
    }

    std::vector<Row> rows_;
    std::size_t count_ = 0;
    std::vector<T> inverse_masses_;
    std::array<Numbers, 4> properties_;  ///< of each pair: masses, charges
};

}  // namespace steplab
