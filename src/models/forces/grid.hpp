#pragma once

#include "core/elementwise.hpp"
#include "core/field.hpp"
#include "core/field_lanes.hpp"
#include "core/force_layout.hpp"
#include "core/lanes.hpp"
#include "core/sum.hpp"
#include "models/forces/forces.hpp"
#include "models/forces/interactions.hpp"
#include "models/forces/spring.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <vector>

namespace steplab {

/// The engine of GridForces. Particle (row i, column j) has index i * columns + j and reference position (j L, 0, -i
/// L). Every spring is computed once, with its first particle: to the east (i, j+1), south (i+1, j), south-east and
/// south-west. The acceleration is k / m times (E - E of west) + ((S + (SE + SW)) - (S of north + (SE of north-west +
/// SW of north-east))). The particles of the border are fixed. The grid is processed as one sequence of particles, a
/// register at a time: springs from the end of a row to the beginning of the next are computed too, but act on the
/// fixed border only.
template <class T>
class Grid {
    using N = Lanes<T>;
    using Vec = Vector<N>;
    static constexpr std::size_t width = N::count;
    /// Registers between computing pulls and summing them in narrow grids: partial loads of recent stores are slow.
    static constexpr std::size_t behind = 3;
    /// Largest number of columns of such grids; with registers of a cache line this brings no gain.
    static constexpr std::size_t narrow = width * sizeof(T) < 64 ? 4 * width - 1 : 0;

public:
    static constexpr ForceCapabilities capabilities{.sweeps = true};

    explicit Grid(const GridForces& forces)
        : forces_(forces),
          stiffness_(static_cast<T>(forces.k) / static_cast<T>(forces.mass)),
          length_(static_cast<T>(forces.rest_length)),
          diagonal_(static_cast<T>(std::sqrt(2.0) * forces.rest_length)),
          inner_(forces.columns + width) {
        for (std::size_t k = 0; k < inner_.size(); ++k)
            inner_[k] = T(k % forces.columns > 0 && (k + 1) % forces.columns > 0);
    }

    /// The same forces in another number type.
    template <class N>
    Grid<N> in() const {
        return Grid<N>(forces_);
    }

    /// Calls f(number) for the constants that depend on the scene's parameters.
    template <class Self, class F>
    static void each_constant(Self& self, F f) {
        f(self.stiffness_), f(self.length_), f(self.diagonal_);
    }

    void accelerations(const Field<T>& u, Field<T>& a) {
        const FieldLanes<T> out(a);
        sweep_.restart();
        sweep_.to(*this, registers(), FieldLanes<const T>(u), [&](std::size_t r, const Vec& sum) { out.set(r, sum); });
    }

    /// One sweep over all particles (methods/engines/sweeps.hpp). `positions.get_from(p)` are those of a register of
    /// particles from p on; sink(r, a) is called with the accelerations of the r-th register of particles when their
    /// positions are no longer needed.
    class Sweep {
    public:
        void restart() { at_ = 0; }
        /// The next register.
        std::size_t at() const { return at_; }
        /// Continues up to this register.
        template <class Positions, class Sink>
        void to(const Grid& grid, std::size_t end, Positions positions, Sink sink) {
            if (at_ >= end) return;
            if (at_ == 0) begin(grid);
            Passed passed = passed_;
            if (grid.forces_.columns > narrow) {
                // The kick of a register follows the springs of the next one: it overlaps with their divisions.
                std::size_t r = at_;
                Vec late = sum(grid, r, pass(grid, r, positions, passed));
                for (++r; r < end; ++r) {
                    const Vec next = sum(grid, r, pass(grid, r, positions, passed));
                    sink(r - 1, late);
                    late = next;
                }
                sink(r - 1, late);
                at_ = end;
            } else {
                for (; at_ < end; ++at_) {
                    for (const std::size_t ahead = std::min(at_ + behind + 1, grid.registers()); passed_by_ < ahead;
                         ++passed_by_)
                        own_[passed_by_ % own_.size()] = pass(grid, passed_by_, positions, passed);
                    sink(at_, sum(grid, at_, own_[at_ % own_.size()]));
                }
            }
            passed_ = passed;
        }

    private:
        /// Pulls of the springs that begin at a register of particles, and at their eastern neighbours.
        struct Passed {
            Vec east, south_east, south_west;
        };
        /// For a register of particles: east minus west, and south.
        struct Own {
            Vec along_row, south;
        };

        void begin(const Grid& grid) {
            const std::size_t size = std::bit_ceil(grid.forces_.columns + (behind + 2) * width);
            if (ring_ != size) from_north_.assign(3 * (size + width), T(0));
            ring_ = size;
            const N zero(T(0));
            const Vec none{zero, zero, zero};
            passed_ = {none, none, none};
            passed_by_ = 0;
        }

        /// Computes the springs that begin at the r-th register of particles, except those to the south-west, which
        /// begin at their eastern neighbours, so that all of them connect the same four places.
        template <class Positions>
        [[gnu::always_inline]] Own pass(const Grid& grid, std::size_t r, const Positions& positions, Passed& passed) {
            const std::size_t p = r * width, columns = grid.forces_.columns;
            if (p >= grid.last_row()) return {};
            const N length(grid.length_), back = N(T(0)) - length, diagonal(grid.diagonal_), k(grid.stiffness_);
            const Vec here = positions.get(r), at_east = positions.get_from(p + 1);
            const Vec at_south = positions.get_from(p + columns), at_south_east = positions.get_from(p + columns + 1);
            const Vec east = spring_pull(Offset<N, Zero, Zero>{length, {}, {}}, length, k, at_east - here);
            const Vec south = spring_pull(Offset<Zero, Zero, N>{{}, {}, back}, length, k, at_south - here);
            const Vec south_east = spring_pull(Offset<N, Zero, N>{length, {}, back}, diagonal, k, at_south_east - here);
            const Vec south_west = spring_pull(Offset<N, Zero, N>{back, {}, back}, diagonal, k, at_south - at_east);
            const Own own{east - shifted_up(passed.east, east),
                          south + (south_east + shifted_up(passed.south_west, south_west))};
            keep(p, south + (shifted_up(passed.south_east, south_east) + south_west));
            passed = {east, south_east, south_west};
            return own;
        }
        [[gnu::always_inline]] static Vec shifted_up(const Vec& before, const Vec& here) {
            return {N::shifted_up(before.x, here.x), N::shifted_up(before.y, here.y), N::shifted_up(before.z, here.z)};
        }

        T* from_north(std::size_t c) { return from_north_.data() + c * (ring_ + width); }
        /// For the next row.
        [[gnu::always_inline]] void keep(std::size_t p, const Vec& pull) {
            const std::size_t place = p & (ring_ - 1);
            const auto store = [&](std::size_t to) __attribute__((always_inline)) {
                pull.x.store(from_north(0) + to), pull.y.store(from_north(1) + to), pull.z.store(from_north(2) + to);
            };
            store(place);
            if (place == 0) store(ring_);
        }

        /// The accelerations of the r-th register of particles: zero on the border.
        [[gnu::always_inline]] Vec sum(const Grid& grid, std::size_t r, const Own& own) {
            const N zero(T(0));
            const std::size_t columns = grid.forces_.columns, last_row = grid.last_row(), p = r * width;
            if (p + width <= columns || p >= last_row) return {zero, zero, zero};
            const auto inner = N::load_anywhere(grid.inner_.data() + p % columns) > zero;
            const std::size_t place = (p - columns) & (ring_ - 1);
            const auto component = [&](const N& along_row, const N& south, std::size_t c)
                __attribute__((always_inline)) {
                N a = where(inner, along_row + (south - N::load_anywhere(from_north(c) + place)), zero);
                if (p < columns) a = where(N::first(columns - p), zero, a);
                if (p + width > last_row) a = where(N::first(last_row - p), a, zero);
                return a;
            };
            return {component(own.along_row.x, own.south.x, 0), component(own.along_row.y, own.south.y, 1),
                    component(own.along_row.z, own.south.z, 2)};
        }

        std::size_t at_ = 0;         ///< register whose accelerations are next
        std::size_t passed_by_ = 0;  ///< register whose springs are next, if ahead of at_
        Passed passed_{};
        std::array<Own, behind + 1> own_{};
        std::size_t ring_ = 0;  ///< number of stored sums of pulls by the previous row, a power of 2
        std::vector<T, CacheLineAllocator<T>> from_north_;
    };

    /// Number of registers that a sweep reads ahead.
    std::size_t registers_ahead() const { return behind + (forces_.columns + 1) / width + 2; }
    static constexpr std::size_t sweeps_together = 16, registers_a_turn = 1536, bytes_alone = std::size_t{1} << 20;

    PotentialEnergy potential(const Field<T>& u) const { return potential(u, forces_.rows); }
    /// The energy of the springs that begin at the particles of the first `own` rows.
    PotentialEnergy potential(const Field<T>& u, std::size_t own) const {
        LanesSum<Many> sum;
        for (std::size_t d = east; d <= south_west; ++d) {
            const Direction way = direction(d);
            for (std::size_t row = 0; row < std::min(own, forces_.rows - way.rows); ++row)
                add_energies(u, way, row * forces_.columns + way.first, way.last - way.first, sum);
        }
        const double value = forces_.k * sum.value();
        return {value, value, 0};
    }

    /// Calls f(first, second) for springs that reverse between two positions. All springs of a direction are tested
    /// first, including those from the end of a row to the next one, whose particles are fixed.
    template <class F>
    void passing_pairs(const Field<T>& from, const Field<T>& to, F f) const {
        const std::size_t columns = forces_.columns;
        for (std::size_t d = east; d <= south_west; ++d) {
            const Direction way = direction(d);
            const auto turned = [&, offset = way.offset](std::size_t p) {
                return turned_round(spring(from, way, p, offset), spring(to, way, p, offset));
            };
            const std::size_t first = way.first, end = (forces_.rows - way.rows - 1) * columns + way.last;
            if (!any_of_all(end - first, [=](std::size_t k) { return turned(first + k); })) continue;
            for (std::size_t p = first; p < end; ++p) {
                const std::size_t column = p % columns;
                if (way.first <= column && column < way.last && turned(p))
                    f(static_cast<std::uint32_t>(p), static_cast<std::uint32_t>(p + way.offset));
            }
        }
    }

    Coupling coupling() const { return steplab::coupling(forces_); }
    bool moves(std::size_t p) const {
        const std::size_t row = p / forces_.columns, column = p % forces_.columns;
        return row > 0 && row + 1 < forces_.rows && column > 0 && column + 1 < forces_.columns;
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
        const std::size_t columns = forces_.columns;
        for (std::size_t d = east; d <= south_west; ++d) {
            const Direction way = direction(d);
            for (std::size_t i = 0; i + way.rows < forces_.rows; ++i) {
                for (std::size_t p = i * columns + way.first; p < i * columns + way.last; ++p) {
                    if (moves(p) || moves(p + way.offset)) f(p, p + way.offset, d);
                }
            }
        }
    }

    /// The vector from particle i to particle j.
    Vector<T> separation(const Field<T>& u, std::size_t i, std::size_t j) const {
        const auto steps = [](std::size_t from, std::size_t to) { return static_cast<T>(to) - static_cast<T>(from); };
        const std::size_t columns = forces_.columns;
        const T along_row = steps(i % columns, j % columns), rows = steps(i / columns, j / columns);
        return {length_ * along_row + (u.x()[j] - u.x()[i]), u.y()[j] - u.y()[i],
                (u.z()[j] - u.z()[i]) - length_ * rows};
    }

private:
    std::size_t registers() const { return (forces_.rows * forces_.columns + width - 1) / width; }
    /// The first particle of the last row, whose springs connect fixed particles only.
    std::size_t last_row() const { return (forces_.rows - 1) * forces_.columns; }

    /// The springs that begin at a particle.
    enum : std::size_t { east, south, south_east, south_west };

    struct Direction {
        Vector<T> rest;
        T length;
        std::size_t offset;       ///< of the second particle's index
        std::size_t rows;         ///< 1 if the second particle is in the next row
        std::size_t first, last;  ///< columns of first particles: [first, last)
    };

    Direction direction(std::size_t d) const {
        const std::size_t columns = forces_.columns;
        const T l = length_, o = T(0);
        switch (d) {
            case east:
                return {{l, o, o}, length_, 1, 0, 0, columns - 1};
            case south:
                return {{o, o, -l}, length_, columns, 1, 0, columns};
            case south_east:
                return {{l, o, -l}, diagonal_, columns + 1, 1, 0, columns - 1};
            default:
                return {{-l, o, -l}, diagonal_, columns - 1, 1, 1, columns};
        }
    }

    /// The vector along the spring of one direction that begins at particle p.
    static Vector<T> spring(const Field<T>& u, const Direction& way, std::size_t p, std::size_t offset) {
        const std::size_t q = p + offset;
        return {way.rest.x + (u.x()[q] - u.x()[p]), u.y()[q] - u.y()[p], way.rest.z + (u.z()[q] - u.z()[p])};
    }

    using Many = CacheLineLanes<T>;
    /// For `count` springs of one direction, starting with that of this particle.
    static void add_energies(const Field<T>& u, const Direction& way, std::size_t first, std::size_t count,
                             LanesSum<Many>& sum) {
        const BasicFieldLanes<const T, Many> at(u);
        const Vector<Many> rest{Many(way.rest.x), Many(way.rest.y), Many(way.rest.z)};
        for (std::size_t k = 0; k < count; k += Many::count) {
            const Vector<Many> e = at.get_from(first + k + way.offset) - at.get_from(first + k);
            const Many energy = spring_energy(rest, Many(way.length), e);
            sum.add(where(Many::first(count - k), energy, Many(T(0))));
        }
    }

    GridForces forces_;
    T stiffness_;  ///< k / m
    T length_;
    T diagonal_;
    std::vector<T> inner_;  ///< 1 for the inner columns of a row and of its continuation, else 0
    Sweep sweep_;
};

}  // namespace steplab
