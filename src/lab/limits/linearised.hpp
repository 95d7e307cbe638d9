#pragma once

#include "core/dual.hpp"
#include "core/field.hpp"
#include "core/shape.hpp"
#include "sim/catalogue.hpp"

#include <Eigen/Core>
#include <cstddef>
#include <functional>
#include <vector>

namespace steplab {

/// A symmetric matrix as what it makes of a vector.
using LinearMap = std::function<Eigen::VectorXd(const Eigen::VectorXd&)>;

/// Eigenvalues and eigenvectors of a symmetric matrix.
struct Eigenpairs {
    Eigen::VectorXd values;   ///< ascending
    Eigen::MatrixXd vectors;  ///< a column each, of length 1
    /// Every distinct eigenvalue is among them. If not, the largest is one, and the others stand for what lies between.
    bool complete = false;
    double residual = 0;  ///< |A v - lambda v| of the last one: lambda is an eigenvalue within so much
};

/// The method of Lanczos with full reorthogonalisation (Golub, Van Loan, Matrix Computations, 10.1 and 10.3), from a
/// fixed start. A matrix of up to 300 rows is followed to the end.
Eigenpairs lanczos(const LinearMap& matrix, Eigen::Index size);

/// A scene linearised at its start: u'' = -K u - gamma u' for small displacements u of its moving particles. -K is the
/// Jacobian of the accelerations, exact from dual numbers.
class LinearisedScene {
public:
    LinearisedScene(const Scene& scene, const Shape& shape);

    /// Numbers in u: three for each moving particle.
    Eigen::Index size() const { return static_cast<Eigen::Index>(moving_.size()); }
    /// K u.
    Eigen::VectorXd stiffness(const Eigen::VectorXd& u) const;
    /// u as displacements of all particles, and back; fixed ones have none.
    Field<double> field(const Eigen::VectorXd& u) const;
    Eigen::VectorXd vector(const Field<double>& displacements) const;

private:
    using Number = Dual<double>;

    Field<double> start_;
    std::vector<std::size_t> moving_;  ///< places in Field::flat()
    std::function<void(const Field<Number>&, Field<Number>&)> accelerations_;
};

/// The modes of a linearised scene: eigenvalues omega^2 of K. Where one is negative the scene departs by itself.
Eigenpairs modes(const LinearisedScene& scene);
/// The largest angular frequency, 0 if nothing oscillates.
double highest_frequency(const Eigenpairs& modes);

}  // namespace steplab
