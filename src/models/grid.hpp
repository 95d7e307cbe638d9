#pragma once

#include "core/elementwise.hpp"
#include "core/field.hpp"
#include "core/lanes.hpp"
#include "core/sum.hpp"
#include "models/forces.hpp"
#include "models/interactions.hpp"
#include "models/spring.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

namespace steplab {

/// GridForces at work. Particle (row i, column j) has index i * dim + j and reference position (j L, 0, -i L).
/// Every spring is computed once, with its first particle: to the east (i, j+1), south (i+1, j), south-east and
/// south-west. The acceleration is k / m times ((E - E of west) + (S - S of north)) + ((SE - SE of north-west) + (SW -
/// SW of north-east)). The particles of the border are fixed. The grid is one run of particles, a register of them at a
/// time: springs from the end of a row to the beginning of the next are computed too, but pull at the border alone.
template <class T>
class Grid {
public:
    explicit Grid(const GridForces& forces)
        : forces_(forces),
          stiffness_(static_cast<T>(forces.k) / static_cast<T>(forces.mass)),
          length_(static_cast<T>(forces.rest_length)),
          diagonal_(static_cast<T>(std::sqrt(2.0) * forces.rest_length)),
          lead_(padded(forces.dim + 1)),
          chunk_(std::min(padded(forces.dim * forces.dim), std::max(most_numbers / components, lead_))),
          pulls_(components * stride(), T(0)),
          inner_(forces.dim + width) {
        for (std::size_t k = 0; k < inner_.size(); ++k) inner_[k] = T(k % forces.dim > 0 && (k + 1) % forces.dim > 0);
    }

    /// The same forces in another number type.
    template <class N>
    Grid<N> in() const {
        return Grid<N>(forces_);
    }

    void accelerations(const Field<T>& u, Field<T>& a) {
        const std::size_t dim = forces_.dim, springs = (dim - 1) * dim;  // the rest are those of the fixed last row
        for (std::size_t begin = 0; begin < springs; begin += chunk_) {
            if (begin > 0) keep_last_pulls();
            const std::size_t end = std::min(begin + chunk_, springs);
            std::size_t next = std::max(begin, dim / width * width);
            for (std::size_t p = begin; p < end; p += width) {
                compute_pulls(u, p, p - begin);
                if (p < next + behind * width) continue;
                add_pulls(a, next, next - begin);
                next += width;
            }
            for (; next < end; next += width) add_pulls(a, next, next - begin);
        }
    }

    PotentialEnergy potential(const Field<T>& u) const {
        const std::size_t dim = forces_.dim;
        CompensatedSum sum;
        for (std::size_t d = east; d <= south_west; ++d) {
            const Direction way = direction(d);
            for (std::size_t i = 0; i + way.rows < dim; ++i) {
                for (std::size_t j = way.first; j < way.last; ++j) sum.add(energy(u, way, i * dim + j));
            }
        }
        const double value = forces_.k * sum.value();
        return {value, value, 0};
    }

    /// Calls f(first, second) for springs that turn round between two positions.
    template <class F>
    void passing_pairs(const Field<T>& from, const Field<T>& to, F f) const {
        for (std::size_t d = east; d <= south_west; ++d) {
            const Direction way = direction(d);
            for (std::size_t i = 0; i + way.rows < forces_.dim; ++i) {
                const std::size_t start = i * forces_.dim + way.first;
                const auto turned = [&, offset = way.offset](std::size_t j) {
                    return turned_round(spring(from, way, start + j, offset), spring(to, way, start + j, offset));
                };
                if (!any_of_all(way.last - way.first, turned)) continue;
                for (std::size_t j = 0; j < way.last - way.first; ++j) {
                    const std::size_t first = start + j;
                    if (turned(j)) f(static_cast<std::uint32_t>(first), static_cast<std::uint32_t>(first + way.offset));
                }
            }
        }
    }

    Coupling coupling() const { return steplab::coupling(forces_); }
    bool moves(std::size_t p) const {
        const std::size_t last = forces_.dim - 1, row = p / forces_.dim, column = p % forces_.dim;
        return row > 0 && row < last && column > 0 && column < last;
    }
    Vector<T> external(std::size_t) const { return {T(0), T(0), T(0)}; }

    std::array<SpringFormula<T>, 4> formulas() const {
        const auto spring = [this](std::size_t d) {
            const Direction way = direction(d);
            return SpringFormula<T>{way.rest, way.length, stiffness_};
        };
        return {spring(east), spring(south), spring(south_east), spring(south_west)};
    }

    /// Springs between two particles of the border are left out.
    template <class F>
    void each_interaction(const Field<T>&, F f) const {
        const std::size_t dim = forces_.dim;
        for (std::size_t d = east; d <= south_west; ++d) {
            const Direction way = direction(d);
            for (std::size_t i = 0; i + way.rows < dim; ++i) {
                for (std::size_t p = i * dim + way.first; p < i * dim + way.last; ++p) {
                    if (moves(p) || moves(p + way.offset)) f(p, p + way.offset, d);
                }
            }
        }
    }

    /// The vector from particle i to particle j.
    Vector<T> separation(const Field<T>& u, std::size_t i, std::size_t j) const {
        const auto steps = [](std::size_t from, std::size_t to) { return static_cast<T>(to) - static_cast<T>(from); };
        const T columns = steps(i % forces_.dim, j % forces_.dim), rows = steps(i / forces_.dim, j / forces_.dim);
        return {length_ * columns + (u.x()[j] - u.x()[i]), u.y()[j] - u.y()[i], (u.z()[j] - u.z()[i]) - length_ * rows};
    }

private:
    using N = Lanes<T>;
    using Vec = Vector<N>;
    static constexpr std::size_t width = N::count;
    static std::size_t padded(std::size_t n) { return (n + width - 1) / width * width; }

    /// Components of pulls in memory: x, y, z of four directions.
    static constexpr std::size_t components = 12;
    /// Numbers of pulls in memory at a time, so that they stay in the cache.
    static constexpr std::size_t most_numbers =
        components * ((std::size_t(1) << 17) / components / sizeof(T) / width * width);
    /// Registers between computing pulls and adding them up: what has just been stored is slow to load in parts.
    static constexpr std::size_t behind = 3;

    /// The springs a particle is the first particle of.
    enum : std::size_t { east, south, south_east, south_west };

    struct Direction {
        Vector<T> rest;
        T length;
        std::size_t offset;       ///< of the second particle's index
        std::size_t rows;         ///< 1 if the second particle is in the next row
        std::size_t first, last;  ///< columns of first particles: [first, last)
    };

    Direction direction(std::size_t d) const {
        const std::size_t dim = forces_.dim;
        const T l = length_, o = T(0);
        switch (d) {
            case east:
                return {{l, o, o}, length_, 1, 0, 0, dim - 1};
            case south:
                return {{o, o, -l}, length_, dim, 1, 0, dim};
            case south_east:
                return {{l, o, -l}, diagonal_, dim + 1, 1, 0, dim - 1};
            default:
                return {{-l, o, -l}, diagonal_, dim - 1, 1, 1, dim};
        }
    }

    /// The vector along the spring of one direction that begins at particle p.
    static Vector<T> spring(const Field<T>& u, const Direction& way, std::size_t p, std::size_t offset) {
        const std::size_t q = p + offset;
        return {way.rest.x + (u.x()[q] - u.x()[p]), u.y()[q] - u.y()[p], way.rest.z + (u.z()[q] - u.z()[p])};
    }

    /// One component of the pulls of one direction: behind this place those of the particles of the chunk, in front of
    /// it those of the row before.
    T* pulls(std::size_t d, std::size_t c) { return pulls_.data() + (3 * d + c) * stride() + lead_; }
    const T* pulls(std::size_t d, std::size_t c) const { return pulls_.data() + (3 * d + c) * stride() + lead_; }
    /// An odd number of registers, so that the components do not meet in the same sets of the cache.
    std::size_t stride() const { return (((lead_ + chunk_) / width + 1) | 1) * width; }

    void keep_last_pulls() {
        for (std::size_t k = 0; k < pulls_.size(); k += stride())
            std::copy_n(pulls_.data() + k + chunk_, lead_, pulls_.data() + k);
    }

    /// Of the springs that begin at the particles of one register, whose first is particle p and k-th of the chunk.
    [[gnu::always_inline]] void compute_pulls(const Field<T>& u, std::size_t p, std::size_t k) {
        const Vec here{N::load(u.x() + p), N::load(u.y() + p), N::load(u.z() + p)};
        compute_pulls<east>(u, p, k, here);
        compute_pulls<south>(u, p, k, here);
        compute_pulls<south_east>(u, p, k, here);
        compute_pulls<south_west>(u, p, k, here);
    }
    template <std::size_t D>
    [[gnu::always_inline]] void compute_pulls(const Field<T>& u, std::size_t p, std::size_t k, const Vec& here) {
        const Direction way = direction(D);
        const std::size_t q = p + way.offset;
        const Vec e{N::load_anywhere(u.x() + q) - here.x, N::load_anywhere(u.y() + q) - here.y,
                    N::load_anywhere(u.z() + q) - here.z};
        const Vec pull = spring_pull(Vec{N(way.rest.x), N(way.rest.y), N(way.rest.z)}, N(way.length), e);
        pull.x.store(pulls(D, 0) + k);
        pull.y.store(pulls(D, 1) + k);
        pull.z.store(pulls(D, 2) + k);
    }

    /// The accelerations of the same particles: none on the border.
    [[gnu::always_inline]] void add_pulls(Field<T>& a, std::size_t p, std::size_t k) const {
        const std::size_t dim = forces_.dim, last_row = (dim - 1) * dim;
        const std::array<T*, 3> out{a.x() + p, a.y() + p, a.z() + p};
        const N zero(T(0));
        const auto inner = N::load_anywhere(inner_.data() + p % dim) > zero;
        for (std::size_t c = 0; c < 3; ++c) {
            N sum = where(inner, N(stiffness_) * sum_of_pulls(k, c), zero);
            if (p < dim) sum = where(N::first(dim - p), zero, sum);
            if (p + width > last_row) sum = where(N::first(last_row - p), sum, zero);
            sum.store(out[c]);
        }
    }

    [[gnu::always_inline]] N sum_of_pulls(std::size_t k, std::size_t c) const {
        const std::size_t dim = forces_.dim;
        const T *const e = pulls(east, c) + k, *const s = pulls(south, c) + k;
        const T *const se = pulls(south_east, c) + k, *const sw = pulls(south_west, c) + k;
        const N along_row = N::load(e) - N::load_anywhere(e - 1);
        const N along_column = N::load(s) - N::load_anywhere(s - dim);
        const N falling = N::load(se) - N::load_anywhere(se - dim - 1);
        const N rising = N::load(sw) - N::load_anywhere(sw - dim + 1);
        return (along_row + along_column) + (falling + rising);
    }

    double energy(const Field<T>& u, const Direction& way, std::size_t p) const {
        const std::size_t q = p + way.offset;
        const Vector<T> e{u.x()[q] - u.x()[p], u.y()[q] - u.y()[p], u.z()[q] - u.z()[p]};
        return static_cast<double>(spring_energy(way.rest, way.length, e));
    }

    GridForces forces_;
    T stiffness_;  ///< k / m
    T length_;
    T diagonal_;
    std::size_t lead_;                             ///< particles of a row and one, a whole number of registers
    std::size_t chunk_;                            ///< particles whose pulls are in memory at a time, likewise
    std::vector<T, CacheLineAllocator<T>> pulls_;  ///< of every direction: x, y, z
    std::vector<T> inner_;                         ///< 1 for the inner columns of a row and of what follows it, else 0
};

}  // namespace steplab
