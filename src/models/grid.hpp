#pragma once

#include "core/elementwise.hpp"
#include "core/field.hpp"
#include "core/sum.hpp"
#include "models/forces.hpp"
#include "models/interactions.hpp"
#include "models/spring.hpp"

#include <array>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

namespace steplab {

/// GridForces at work. Particle (row i, column j) has index i * dim + j and reference position (j L, 0, -i L).
/// Every spring is computed once, in the row of its first particle: to the east (i, j+1), south (i+1, j), south-east
/// and south-west. The acceleration is ((E - E of west) + (S - S of north)) + ((SE - SE of north-west) + (SW - SW of
/// north-east)). The particles of the border are fixed.
template <class T>
class Grid {
public:
    explicit Grid(const GridForces& forces)
        : forces_(forces),
          stiffness_(static_cast<T>(forces.k) / static_cast<T>(forces.mass)),
          length_(static_cast<T>(forces.rest_length)),
          diagonal_(static_cast<T>(std::sqrt(2.0) * forces.rest_length)) {
        for (auto& buffer : pulls_) buffer.assign(3 * forces.dim, T(0));
    }

    /// The same forces in another number type.
    template <class N>
    Grid<N> in() const {
        return Grid<N>(forces_);
    }

    void accelerations(const Field<T>& u, Field<T>& a) {
        const std::size_t dim = forces_.dim;
        southward_pulls(u, 0);
        for (std::size_t i = 1; i + 1 < dim; ++i) {
            for (std::size_t d = south; d <= south_west; ++d) std::swap(pulls_[d], pulls_[d + 3]);
            compute_pulls(u, i, east);
            southward_pulls(u, i);
            for (std::size_t c = 0; c < 3; ++c) combine(component(a, c) + i * dim, c * dim);
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
    /// The springs a particle is the first particle of, and where their pulls are kept; three more buffers hold the
    /// southward pulls of the row before.
    enum : std::size_t { east, south, south_east, south_west, buffers = 7 };

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

    static T* component(Field<T>& f, std::size_t c) { return c == 0 ? f.x() : c == 1 ? f.y() : f.z(); }

    void southward_pulls(const Field<T>& u, std::size_t i) {
        for (std::size_t d = south; d <= south_west; ++d) compute_pulls(u, i, d);
    }

    /// Pulls of the springs of one direction that begin in row i.
    void compute_pulls(const Field<T>& u, std::size_t i, std::size_t d) {
        const std::size_t dim = forces_.dim;
        const Direction way = direction(d);
        const std::size_t start = i * dim + way.first, offset = way.offset;
        const T *const x = u.x() + start, *const y = u.y() + start, *const z = u.z() + start;
        T* const pulls = pulls_[d].data() + way.first;
        elementwise(way.last - way.first, [=, stiffness = stiffness_](std::size_t j) {
            const Vector<T> e{x[j + offset] - x[j], y[j + offset] - y[j], z[j + offset] - z[j]};
            const Vector<T> pull = spring_pull(way.rest, way.length, e);
            pulls[j] = stiffness * pull.x;
            pulls[j + dim] = stiffness * pull.y;
            pulls[j + 2 * dim] = stiffness * pull.z;
        });
    }

    /// One component of the accelerations of a row's inner particles; `c` is where the component begins in the buffers.
    void combine(T* a, std::size_t c) const {
        const T *const e = pulls_[east].data() + c, *const s = pulls_[south].data() + c;
        const T *const se = pulls_[south_east].data() + c, *const sw = pulls_[south_west].data() + c;
        const T* const n = pulls_[south + 3].data() + c;
        const T *const nw = pulls_[south_east + 3].data() + c, *const ne = pulls_[south_west + 3].data() + c;
        elementwise(forces_.dim - 2, [=](std::size_t k) {
            const std::size_t j = k + 1;
            a[j] = ((e[j] - e[j - 1]) + (s[j] - n[j])) + ((se[j] - nw[j - 1]) + (sw[j] - ne[j + 1]));
        });
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
    std::array<std::vector<T>, buffers> pulls_;  ///< per direction: x, y, z of one row
};

}  // namespace steplab
