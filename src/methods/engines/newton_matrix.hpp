#pragma once

#include "core/block.hpp"
#include "core/coupling.hpp"
#include "core/field.hpp"

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace steplab {

namespace detail {

template <class T>
std::array<T, 3> vector_at(const Field<T>& field, std::size_t i) {
    return {field.x()[i], field.y()[i], field.z()[i]};
}
template <class T>
void set_vector(Field<T>& field, std::size_t i, const std::array<T, 3>& value) {
    field.x()[i] = value[0];
    field.y()[i] = value[1];
    field.z()[i] = value[2];
}

}  // namespace detail

/// A symmetric matrix whose 3 x 3 blocks couple each particle with the next alone, solved by block elimination (Golub,
/// Van Loan, Matrix Computations, 4.5.1) in time proportional to the number of particles.
template <class T>
class BlockTridiagonal {
public:
    explicit BlockTridiagonal(std::size_t particles) : diagonal_(particles), next_(particles) {}

    void reset(T diagonal, const std::vector<T>& masses) {
        diagonal_.assign(diagonal_.size(), Block<T>::diagonal(diagonal));
        for (std::size_t i = 0; i < masses.size(); ++i) diagonal_[i] = Block<T>::diagonal(masses[i] * diagonal);
        next_.assign(next_.size(), Block<T>{});
    }
    void add_diagonal(std::size_t i, const Block<T>& block) { diagonal_[i] += block; }
    void add_beside(std::size_t i, std::size_t, const Block<T>& block) { next_[i] += block; }

    /// Leaves the inverses of the pivots in the diagonal. False if one has none.
    bool factorise() {
        for (std::size_t i = 0; i < diagonal_.size(); ++i) {
            if (i > 0) diagonal_[i] += T(-1) * (transposed(next_[i - 1]) * (diagonal_[i - 1] * next_[i - 1]));
            diagonal_[i] = inverse(diagonal_[i]);
            if (!std::isfinite(diagonal_[i].at[0][0] + diagonal_[i].at[1][1] + diagonal_[i].at[2][2])) return false;
        }
        return true;
    }

    void solve(const Field<T>& right, Field<T>& solution) {
        const std::size_t n = diagonal_.size();
        solution = right;
        for (std::size_t i = 1; i < n; ++i)
            subtract(solution, i, transposed(next_[i - 1]) * (diagonal_[i - 1] * detail::vector_at(solution, i - 1)));
        for (std::size_t i = n; i-- > 0;) {
            if (i + 1 < n) subtract(solution, i, next_[i] * detail::vector_at(solution, i + 1));
            detail::set_vector(solution, i, diagonal_[i] * detail::vector_at(solution, i));
        }
    }

private:
    static void subtract(Field<T>& field, std::size_t i, const std::array<T, 3>& value) {
        field.x()[i] -= value[0];
        field.y()[i] -= value[1];
        field.z()[i] -= value[2];
    }

    std::vector<Block<T>> diagonal_, next_;
};

/// A symmetric matrix of any sparsity: Eigen's sparse L D L^T, whose arithmetic is scalar and in one fixed order. The
/// order of elimination is found again only when the pattern has changed.
template <class T>
class SparseSymmetric {
public:
    explicit SparseSymmetric(std::size_t particles)
        : size_(static_cast<Eigen::Index>(3 * particles)), matrix_(size_, size_), right_(size_) {}

    void reset(T diagonal, const std::vector<T>& masses) {
        entries_.clear();
        for (int i = 0; i < size_; ++i)
            entries_.emplace_back(i, i, masses.empty() ? diagonal : masses[static_cast<std::size_t>(i / 3)] * diagonal);
    }
    void add_diagonal(std::size_t i, const Block<T>& block) { add(i, i, block); }
    void add_beside(std::size_t i, std::size_t j, const Block<T>& block) { add(j, i, transposed(block)); }

    bool factorise() {
        matrix_.setFromTriplets(entries_.begin(), entries_.end());
        if (!pattern_is_known()) decomposition_.analyzePattern(matrix_);
        decomposition_.factorize(matrix_);
        return decomposition_.info() == Eigen::Success;
    }

    void solve(const Field<T>& right, Field<T>& solution) {
        for (std::size_t i = 0; i < right.count(); ++i) {
            const auto value = detail::vector_at(right, i);
            for (std::size_t axis = 0; axis < 3; ++axis) right_[static_cast<Eigen::Index>(3 * i + axis)] = value[axis];
        }
        right_ = decomposition_.solve(right_).eval();
        for (std::size_t i = 0; i < right.count(); ++i) {
            const auto k = static_cast<Eigen::Index>(3 * i);
            detail::set_vector(solution, i, {right_[k], right_[k + 1], right_[k + 2]});
        }
    }

private:
    using Matrix = Eigen::SparseMatrix<T>;

    /// The part on and below the diagonal; row particle `i` is not before column particle `j`.
    void add(std::size_t i, std::size_t j, const Block<T>& block) {
        for (std::size_t row = 0; row < 3; ++row) {
            for (std::size_t column = 0; column < (i == j ? row + 1 : 3); ++column)
                entries_.emplace_back(static_cast<int>(3 * i + row), static_cast<int>(3 * j + column),
                                      block.at[row][column]);
        }
    }

    bool pattern_is_known() {
        const int *const columns = matrix_.outerIndexPtr(), *const rows = matrix_.innerIndexPtr();
        std::vector<int> pattern(columns, columns + matrix_.outerSize() + 1);
        pattern.insert(pattern.end(), rows, rows + matrix_.nonZeros());
        if (pattern == pattern_) return true;
        pattern_ = std::move(pattern);
        return false;
    }

    Eigen::Index size_;
    std::vector<Eigen::Triplet<T, int>> entries_;
    Matrix matrix_;
    std::vector<int> pattern_;
    Eigen::SimplicialLDLT<Matrix, Eigen::Lower> decomposition_;
    Eigen::Matrix<T, Eigen::Dynamic, 1> right_;
};

/// The matrix s - q J of Newton's method, J the derivative of all accelerations with respect to all positions: block
/// tridiagonal where particles act on the next alone, else sparse.
template <class T>
class NewtonMatrix {
public:
    NewtonMatrix() = default;
    explicit NewtonMatrix(const Coupling& coupling) {
        if (coupling.kind == Coupling::Kind::none || coupling.kind == Coupling::Kind::chain) {
            tridiagonal_.emplace(coupling.particles);
        } else {
            sparse_ = std::make_unique<SparseSymmetric<T>>(coupling.particles);
        }
    }

    /// s, or s times the mass of each particle: multiplied by the masses, the matrix stays symmetric.
    void reset(T s, const std::vector<T>& masses) {
        visit([&](auto& matrix) { matrix.reset(s, masses); });
    }
    /// Adds the pair i < j with q times its block of J; a particle that does not move has no row. With i = j it is
    /// what acts on i from outside.
    void add(std::size_t i, std::size_t j, const Block<T>& block, bool i_moves, bool j_moves) {
        visit([&](auto& matrix) {
            if (i == j) {
                if (i_moves) matrix.add_diagonal(i, block);
                return;
            }
            if (i_moves) matrix.add_diagonal(i, block);
            if (j_moves) matrix.add_diagonal(j, block);
            if (i_moves && j_moves) matrix.add_beside(i, j, T(-1) * block);
        });
    }
    /// False if the matrix is singular.
    bool factorise() {
        bool done = false;
        visit([&](auto& matrix) { done = matrix.factorise(); });
        return done;
    }
    void solve(const Field<T>& right, Field<T>& solution) {
        visit([&](auto& matrix) { matrix.solve(right, solution); });
    }

private:
    template <class F>
    void visit(F f) {
        tridiagonal_ ? f(*tridiagonal_) : f(*sparse_);
    }

    std::optional<BlockTridiagonal<T>> tridiagonal_;
    std::unique_ptr<SparseSymmetric<T>> sparse_;
};

namespace detail {

/// How many 3 x 3 blocks the factor has below its diagonal, by the order of elimination that SparseSymmetric uses.
inline double blocks_of_factor(std::size_t particles, std::span<const std::array<std::uint32_t, 2>> bonds) {
    using Matrix = Eigen::SparseMatrix<float>;
    struct Counted : Eigen::SimplicialLDLT<Matrix, Eigen::Lower> {
        double entries() const { return this->m_nonZerosPerCol.template cast<double>().sum(); }
    };
    const auto n = static_cast<Eigen::Index>(particles);
    std::vector<Eigen::Triplet<float, int>> entries;
    entries.reserve(particles + bonds.size());
    for (int i = 0; i < n; ++i) entries.emplace_back(i, i, 1.0f);
    for (const auto& [i, j] : bonds)
        entries.emplace_back(static_cast<int>(std::max(i, j)), static_cast<int>(std::min(i, j)), 1.0f);
    Matrix matrix(n, n);
    matrix.setFromTriplets(entries.begin(), entries.end());
    Counted counted;
    counted.analyzePattern(matrix);
    return counted.entries();
}

}  // namespace detail

/// Bytes that NewtonMatrix takes for these pairs, an upper bound: measured for the factor of a sheet, counted for
/// bonds and, as the order of elimination of coordinates is another one, twice that; elsewhere a full triangle. The
/// list of entries may be half empty.
inline double bytes_of_linear_solver(const Coupling& coupling, const Interactions& interactions) {
    using Kind = Coupling::Kind;
    const auto n = static_cast<double>(coupling.particles);
    if (coupling.kind == Kind::none || coupling.kind == Kind::chain) return 2 * sizeof(Block<double>) * n;
    constexpr double entry = 12, in_list = 2 * 16 + 3 * entry;
    const double entries = 9 * (n + interactions.pairs) * in_list, triangle = 4.5 * n * n * entry;
    if (!interactions.bonds.empty()) {
        const double blocks = 2 * detail::blocks_of_factor(coupling.particles, interactions.bonds) + n;
        return entries + std::min(triangle, 9 * blocks * entry);
    }
    const double factor_of_sheet = n * (1500 + 500 * std::log2(n + 1));
    return entries + (coupling.kind == Kind::sheet ? std::min(triangle, factor_of_sheet) : triangle);
}

/// Why systems of this coupling are beyond a linear solver here: one step would take minutes or more memory than
/// machines have.
inline std::optional<std::string> refusal_by_linear_solver(const Coupling& coupling) {
    using Kind = Coupling::Kind;
    const auto beyond = [&](std::size_t most, const char* what) -> std::optional<std::string> {
        if (coupling.particles <= most) return std::nullopt;
        return "it solves a linear system of all particles in every step, and " + std::string(what) +
               " that is possible for up to " + std::to_string(most) + " particles, not for " +
               std::to_string(coupling.particles);
    };
    switch (coupling.kind) {
        case Kind::all:
            return beyond(600, "where all pairs interact");
        case Kind::near:
            return beyond(10000, "where near pairs interact");
        case Kind::sheet:
            return beyond(250000, "in a mesh");
        default:
            return std::nullopt;
    }
}

}  // namespace steplab
