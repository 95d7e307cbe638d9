#include "sim/run/linearised.hpp"

#include "core/error.hpp"
#include "core/interruption.hpp"
#include "core/number_text.hpp"
#include "models/forces/layouts.hpp"
#include "sim/run/run_description.hpp"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

namespace steplab {

namespace {

constexpr Eigen::Index complete_up_to = 300;
constexpr Eigen::Index most_numbers = 100'000'000;  // largest size of a basis
constexpr double converged = 1e-9;                  // residual, relative to the eigenvalue

/// Numbers between -1 and 1, the same on every machine (Knuth's linear congruential generator, MMIX).
Eigen::VectorXd arbitrary_vector(Eigen::Index size) {
    Eigen::VectorXd v(size);
    std::uint64_t state = 1;
    for (double& number : v) {
        state = state * 6364136223846793005u + 1442695040888963407u;
        number = static_cast<double>(state >> 11) * 0x1p-52 - 1;
    }
    return v.normalized();
}

/// True of numbers whose squares neither overflow nor lose digits.
bool has_a_square(double size) { return size > 1e-140 && size < 1e140; }

/// Also of force constants whose squares no number holds.
double length(const Eigen::VectorXd& v) {
    const double plain = v.norm();
    return has_a_square(plain) ? plain : v.stableNorm();
}

/// The power of two, division by which is exact, that brings the largest element near 1: the solver of Eigen 3.4
/// compares squares of elements beside the diagonal with elements on it, and takes small ones for zero.
double scale_of(const std::vector<double>& alpha, const std::vector<double>& beta) {
    double largest = 0;
    for (const double element : alpha) largest = std::max(largest, std::abs(element));
    for (const double element : beta) largest = std::max(largest, std::abs(element));
    if (!(largest > 0) || !std::isfinite(largest)) return 1;
    return std::ldexp(1.0, std::ilogb(largest));
}

/// Eigenvalues, ascending, and eigenvectors of a tridiagonal matrix.
struct Tridiagonal {
    Eigen::VectorXd values;
    Eigen::MatrixXd vectors;
};

/// Of the matrix with these elements on its diagonal and, but for the last, beside it.
Tridiagonal tridiagonal(const std::vector<double>& alpha, const std::vector<double>& beta) {
    const auto steps = static_cast<Eigen::Index>(alpha.size());
    const double scale = scale_of(alpha, beta);
    Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver;
    solver.computeFromTridiagonal(Eigen::Map<const Eigen::VectorXd>(alpha.data(), steps) / scale,
                                  Eigen::Map<const Eigen::VectorXd>(beta.data(), steps - 1) / scale);
    return {solver.eigenvalues() * scale, solver.eigenvectors()};
}

/// The tridiagonal matrix of the Lanczos method, and its basis vectors.
struct Krylov {
    std::vector<double> alpha, beta;  ///< diagonal and off-diagonal elements; the last beta leads out of the space
    Eigen::MatrixXd basis;
    Eigen::Index steps = 0;

    Tridiagonal solve() const { return tridiagonal(alpha, beta); }

    /// Adds a vector; false if the space is closed under the matrix.
    bool step(const LinearMap& matrix) {
        Eigen::VectorXd next = matrix(basis.col(steps));
        alpha.push_back(basis.col(steps).dot(next));
        ++steps;
        const double size = length(next);
        for (int twice = 0; twice < 2; ++twice) {  // twice is enough: Parlett, The Symmetric Eigenvalue Problem, 6.9
            next -= basis.leftCols(steps) * (basis.leftCols(steps).transpose() * next);
        }
        beta.push_back(length(next));
        largest = std::max({largest, size, beta.back()});
        if (!(beta.back() > 1e-12 * largest)) return false;
        if (steps < basis.cols()) basis.col(steps) = next / beta.back();
        return true;
    }

    double largest = 0;  ///< norm of the matrix times a unit vector
};

/// The recurrence of three vectors: the same each time it begins with a vector.
class ThreeTerms {
public:
    ThreeTerms(const LinearMap& matrix, const Eigen::VectorXd& start) : matrix_(matrix), now_(start) {}

    const Eigen::VectorXd& vector() const { return now_; }
    /// On to the next vector; false if there is none.
    bool step() {
        Eigen::VectorXd next = matrix_(now_);
        largest_ = std::max(largest_, length(next));
        alpha.push_back(now_.dot(next));
        next -= alpha.back() * now_;
        if (alpha.size() > 1) next -= beta.back() * before_;
        beta.push_back(length(next));
        if (!(beta.back() > 1e-12 * largest_)) return false;
        before_ = std::exchange(now_, next / beta.back());
        return true;
    }

    std::vector<double> alpha, beta;  ///< as in Krylov

private:
    const LinearMap& matrix_;
    Eigen::VectorXd before_, now_;
    double largest_ = 0;
};

}  // namespace

Eigenpair largest_eigenpair(const LinearMap& matrix, const Eigen::VectorXd& along, double accuracy) {
    constexpr double part_of_others = 0.01;  // `along` may have nothing of the vector
    const Eigen::Index size = along.size();
    if (size == 0) return {};
    Eigen::VectorXd start = arbitrary_vector(size);
    if (const double size_along = length(along); size_along > 0 && std::isfinite(size_along))
        start = (along / size_along + part_of_others * start).normalized();
    ThreeTerms terms(matrix, start);
    Eigenpair found;
    Eigen::VectorXd weights;
    const Eigen::Index most = std::min(2 * size, complete_up_to);  // rounding may repeat some
    for (Eigen::Index steps = 1; steps <= most; ++steps) {
        check_interruption();
        const bool last = !terms.step() || steps == most;
        if (!last && steps % 5 != 0) continue;
        const auto solver = tridiagonal(terms.alpha, terms.beta);
        found.value = solver.values[steps - 1];
        weights = solver.vectors.col(steps - 1);
        found.residual = terms.beta.back() * std::abs(weights[steps - 1]);
        if (last || found.residual <= accuracy * std::abs(found.value)) break;
    }
    ThreeTerms again(matrix, start);
    found.vector = Eigen::VectorXd::Zero(size);
    for (Eigen::Index k = 0; k < weights.size(); ++k) {
        check_interruption();
        found.vector += weights[k] * again.vector();
        if (k + 1 < weights.size()) again.step();
    }
    found.vector.normalize();
    return found;
}

Eigenpairs lanczos(const LinearMap& matrix, Eigen::Index size) {
    if (size == 0) return {.values = {}, .vectors = {}, .complete = true};
    const Eigen::Index most = std::min(size, std::clamp<Eigen::Index>(most_numbers / size, 30, complete_up_to));
    Krylov krylov{.alpha = {}, .beta = {}, .basis = Eigen::MatrixXd(size, most)};
    krylov.basis.col(0) = arbitrary_vector(size);
    bool closed = false;
    const auto residual = [&](const auto& solver) {
        return krylov.beta.back() * std::abs(solver.vectors(krylov.steps - 1, krylov.steps - 1));
    };
    while (!closed && krylov.steps < most) {
        closed = !krylov.step(matrix);
        const bool test = size > complete_up_to && krylov.steps % 10 == 0;
        if (!test || closed) continue;
        const auto solver = krylov.solve();
        if (residual(solver) < converged * std::abs(solver.values(krylov.steps - 1))) break;
    }
    const auto solver = krylov.solve();
    return {.values = solver.values,
            .vectors = krylov.basis.leftCols(krylov.steps) * solver.vectors,
            .complete = closed || krylov.steps == size,
            .residual = residual(solver)};
}

LinearisedScene::LinearisedScene(const Plan& scene, const Shape& shape)
    : LinearisedScene(scene, shape, scene.start.state().displacement) {}

LinearisedScene::LinearisedScene(const Plan& scene, const Shape& shape, Field<double> displacement)
    : place_(std::move(displacement)),
      accelerations_(std::visit(
          [](const auto& forces) -> decltype(accelerations_) {
              return [force = engine<Number>(forces)](const Field<Number>& x, Field<Number>& a) mutable {
                  force.accelerations(x, a);
              };
          },
          scene.forces)) {
    const std::size_t stride = place_.flat().size() / 3;
    for (std::size_t i = 0; i < place_.count(); ++i) {
        if (shape.roles[i] == Role::fixed) continue;
        for (std::size_t component = 0; component < 3; ++component) {
            moving_.push_back(component * stride + i);
            roots_.push_back(scene.masses.empty() ? 1 : std::sqrt(scene.masses[i]));
        }
    }
}

Eigen::VectorXd LinearisedScene::stiffness(const Eigen::VectorXd& u) const {
    Field<Number> x = converted<Number>(place_), a(place_.count());
    const auto at = [](Eigen::Index k) { return static_cast<std::size_t>(k); };
    for (Eigen::Index k = 0; k < u.size(); ++k) x.flat()[moving_[at(k)]].derivative = u[k] / roots_[at(k)];
    accelerations_(x, a);
    Eigen::VectorXd out(u.size());
    for (Eigen::Index k = 0; k < u.size(); ++k) out[k] = -a.flat()[moving_[at(k)]].derivative * roots_[at(k)];
    return out;
}

Field<double> LinearisedScene::field(const Eigen::VectorXd& u) const {
    Field<double> field(place_.count());
    for (Eigen::Index k = 0; k < u.size(); ++k) field.flat()[moving_[static_cast<std::size_t>(k)]] = u[k];
    return field;
}

Field<double> LinearisedScene::displacements(const Eigen::VectorXd& u) const {
    Eigen::VectorXd unweighted(u.size());
    for (Eigen::Index k = 0; k < u.size(); ++k) unweighted[k] = u[k] / roots_[static_cast<std::size_t>(k)];
    return field(unweighted);
}

Eigen::VectorXd LinearisedScene::weighted(const Field<double>& displacements) const {
    Eigen::VectorXd u = vector(displacements);
    for (Eigen::Index k = 0; k < u.size(); ++k) u[k] *= roots_[static_cast<std::size_t>(k)];
    return u;
}

Eigen::VectorXd LinearisedScene::vector(const Field<double>& displacements) const {
    Eigen::VectorXd u(size());
    for (Eigen::Index k = 0; k < u.size(); ++k) u[k] = displacements.flat()[moving_[static_cast<std::size_t>(k)]];
    return u;
}

Eigenpairs modes(const LinearisedScene& scene) {
    const auto product = [&](const Eigen::VectorXd& u) {
        check_interruption();  // of many particles each one takes a while
        return scene.stiffness(u);
    };
    return lanczos(product, scene.size());
}

Eigenpairs all_modes(const LinearisedScene& scene) {
    if (scene.size() == 0) return {{}, {}, true};  // nothing moves
    Eigen::MatrixXd matrix(scene.size(), scene.size());
    for (Eigen::Index k = 0; k < scene.size(); ++k)
        matrix.col(k) = scene.stiffness(Eigen::VectorXd::Unit(scene.size(), k));
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(0.5 * (matrix + matrix.transpose()));
    return {.values = solver.eigenvalues(), .vectors = solver.eigenvectors(), .complete = true};
}

Eigen::Index count_of_still(const Eigen::VectorXd& values) {
    const double zero = values.size() > 0 ? 1e-10 * values.cwiseAbs().maxCoeff() : 0;
    return (values.array() <= zero).count();
}

double highest_frequency(const Eigenpairs& modes) {
    const double largest = modes.values.size() > 0 ? modes.values[modes.values.size() - 1] : 0;
    return std::isfinite(largest) ? std::sqrt(std::max(0.0, largest)) : std::numeric_limits<double>::infinity();
}

void check_stiffness(double omega) {
    if (omega <= largest_frequency) return;
    throw UsageError(
        fmt::format("the scene is too stiff to be judged in double: its largest frequency at the start is "
                    "above {} 1/s",
                    typed(largest_frequency)));
}

}  // namespace steplab
