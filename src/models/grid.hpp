#pragma once

#include "core/elementwise.hpp"
#include "core/field.hpp"
#include "core/field_lanes.hpp"
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
    using N = Lanes<T>;
    using Vec = Vector<N>;
    static constexpr std::size_t width = N::count;

public:
    explicit Grid(const GridForces& forces)
        : forces_(forces),
          stiffness_(static_cast<T>(forces.k) / static_cast<T>(forces.mass)),
          length_(static_cast<T>(forces.rest_length)),
          diagonal_(static_cast<T>(std::sqrt(2.0) * forces.rest_length)),
          inner_(forces.dim + width) {
        for (std::size_t k = 0; k < inner_.size(); ++k) inner_[k] = T(k % forces.dim > 0 && (k + 1) % forces.dim > 0);
    }

    /// The same forces in another number type.
    template <class N>
    Grid<N> in() const {
        return Grid<N>(forces_);
    }

    void accelerations(const Field<T>& u, Field<T>& a) {
        const FieldLanes<T> out(a);
        sweep_.restart();
        sweep_.to(*this, registers(), FieldLanes<const T>(u), [&](std::size_t r, const Vec& sum) { out.set(r, sum); });
    }

    /// One sweep over all particles (methods/sweeps.hpp). `positions.get_from(p)` are those of a register of particles
    /// from p on; sink(r, a) is called with the accelerations of the r-th register of particles once their positions are
    /// needed no more.
    class Sweep {
    public:
        void restart() { at_ = computed_ = begin_ = column_ = 0; }
        /// The register to go on with.
        std::size_t at() const { return at_; }
        /// Goes on up to this register.
        template <class Positions, class Sink>
        void to(const Grid& grid, std::size_t end, Positions positions, Sink sink) {
            if (pulls_.empty()) make_room(grid);
            const std::size_t springs = grid.spring_registers();
            for (; at_ < end; ++at_) {
                for (const std::size_t ahead = std::min(at_ + behind + 1, springs); computed_ < ahead; ++computed_)
                    compute_pulls(grid, positions);
                sink(at_, sum_of_pulls(grid));
                for (column_ += width; column_ >= grid.forces_.dim;) column_ -= grid.forces_.dim;
            }
        }

    private:
        /// Components of pulls: x, y, z of four directions.
        static constexpr std::size_t components = 12;
        /// Numbers of each component in memory at a time, so that they stay in the first-level cache if the grid allows.
        static constexpr std::size_t chunk_bytes = std::size_t(1) << 15;

        void make_room(const Grid& grid) {
            kept_ = padded(grid.forces_.dim + 1) + behind * width;
            chunk_ = std::max(chunk_bytes / components / sizeof(T) / width * width, 2 * kept_) - kept_;
            pulls_.assign(components * stride(), T(0));
        }

        /// From one component to the next, an odd number of registers, so that they do not meet in the same sets of the
        /// cache.
        std::size_t stride() const { return (((kept_ + chunk_) / width + 1) | 1) * width; }
        T* pulls(std::size_t d, std::size_t c) { return pulls_.data() + (3 * d + c) * stride() + kept_; }

        void keep_last_pulls() {
            for (std::size_t k = 0; k < pulls_.size(); k += stride())
                std::copy_n(pulls_.data() + k + chunk_, kept_, pulls_.data() + k);
            begin_ += chunk_;
        }

        /// Of the springs that begin at the particles of the next register.
        template <class Positions>
        [[gnu::always_inline]] void compute_pulls(const Grid& grid, const Positions& positions) {
            if (computed_ * width == begin_ + chunk_) keep_last_pulls();
            const std::size_t p = computed_ * width;
            const Vec here = positions.get(computed_);
            compute_pulls<east>(grid, positions, p, here);
            compute_pulls<south>(grid, positions, p, here);
            compute_pulls<south_east>(grid, positions, p, here);
            compute_pulls<south_west>(grid, positions, p, here);
        }
        template <std::size_t D, class Positions>
        [[gnu::always_inline]] void compute_pulls(const Grid& grid, const Positions& positions, std::size_t p,
                                                  const Vec& here) {
            const Direction way = grid.direction(D);
            const Vec e = positions.get_from(p + way.offset) - here;
            const Vec pull = spring_pull(Vec{N(way.rest.x), N(way.rest.y), N(way.rest.z)}, N(way.length), e);
            pull.x.store(pulls(D, 0) + p - begin_);
            pull.y.store(pulls(D, 1) + p - begin_);
            pull.z.store(pulls(D, 2) + p - begin_);
        }

        /// The accelerations of the register of particles that is next: none on the border.
        [[gnu::always_inline]] Vec sum_of_pulls(const Grid& grid) {
            const N zero(T(0));
            const std::size_t dim = grid.forces_.dim, last_row = (dim - 1) * dim, p = at_ * width;
            if (p + width <= dim || p >= last_row) return {zero, zero, zero};
            auto inner = N::load_anywhere(grid.inner_.data() + column_) > zero;
            const N stiffness(grid.stiffness_);
            const auto sum = [&](std::size_t c) __attribute__((always_inline)) {
                N a = where(inner, stiffness * sum_of_pulls(dim, p, c), zero);
                if (p < dim) a = where(N::first(dim - p), zero, a);
                if (p + width > last_row) a = where(N::first(last_row - p), a, zero);
                return a;
            };
            return {sum(0), sum(1), sum(2)};
        }
        [[gnu::always_inline]] N sum_of_pulls(std::size_t dim, std::size_t p, std::size_t c) {
            const std::ptrdiff_t k = static_cast<std::ptrdiff_t>(p) - static_cast<std::ptrdiff_t>(begin_);
            const T *const e = pulls(east, c) + k, *const s = pulls(south, c) + k;
            const T *const se = pulls(south_east, c) + k, *const sw = pulls(south_west, c) + k;
            const N along_row = N::load(e) - N::load_anywhere(e - 1);
            const N along_column = N::load(s) - N::load_anywhere(s - dim);
            const N falling = N::load(se) - N::load_anywhere(se - dim - 1);
            const N rising = N::load(sw) - N::load_anywhere(sw - dim + 1);
            return (along_row + along_column) + (falling + rising);
        }

        std::size_t at_ = 0;        ///< the register whose accelerations come next
        std::size_t computed_ = 0;  ///< registers of particles whose pulls have been computed
        std::size_t column_ = 0;    ///< of the first particle of the next register
        std::size_t begin_ = 0;     ///< the particle behind the pulls that are kept
        std::size_t kept_ = 0;      ///< particles whose pulls are kept in front of a chunk
        std::size_t chunk_ = 0;     ///< particles of a chunk
        std::vector<T, CacheLineAllocator<T>> pulls_;  ///< of every direction: x, y, z
    };

    /// How many registers ahead of its place a sweep reads.
    std::size_t registers_ahead() const { return behind + (forces_.dim + 1) / width + 2; }
    static constexpr std::size_t sweeps_together() { return 1; }

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
    static std::size_t padded(std::size_t n) { return (n + width - 1) / width * width; }
    std::size_t registers() const { return (forces_.dim * forces_.dim + width - 1) / width; }
    /// Those of the last row belong to fixed particles alone.
    std::size_t spring_registers() const { return ((forces_.dim - 1) * forces_.dim + width - 1) / width; }

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

    double energy(const Field<T>& u, const Direction& way, std::size_t p) const {
        const std::size_t q = p + way.offset;
        const Vector<T> e{u.x()[q] - u.x()[p], u.y()[q] - u.y()[p], u.z()[q] - u.z()[p]};
        return static_cast<double>(spring_energy(way.rest, way.length, e));
    }

    GridForces forces_;
    T stiffness_;  ///< k / m
    T length_;
    T diagonal_;
    std::vector<T> inner_;  ///< 1 for the inner columns of a row and of what follows it, else 0
    Sweep sweep_;
};

}  // namespace steplab
