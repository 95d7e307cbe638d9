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

/// A symmetric matrix, given by its product with a vector.
using LinearMap = std::function<Eigen::VectorXd(const Eigen::VectorXd&)>;

/// Eigenvalues and eigenvectors of a symmetric matrix.
struct Eigenpairs {
    Eigen::VectorXd values;   ///< ascending
    Eigen::MatrixXd vectors;  ///< columns of length 1
    /// True if every distinct eigenvalue is included. If not, the largest is, and the others represent the spectrum
    /// below it.
    bool complete = false;
    double residual = 0;  ///< |A v - lambda v| of the last one, a bound of the error of lambda
};

/// The largest eigenvalue (not the largest in size) and its vector, of length 1.
struct Eigenpair {
    double value = 0;
    Eigen::VectorXd vector;
    double residual = 0;  ///< |A v - lambda v|, a bound of the error of lambda
};

/// By the method of Lanczos in memory for some vectors: without reorthogonalisation, which the largest eigenvalue does
/// not need (Golub, Van Loan, Matrix Computations, 10.3), and with a second pass for its vector. Ends when the residual
/// is below `accuracy` times the eigenvalue, or after 300 products a pass. Where the eigenvalue is a multiple one, the
/// vector is as near as it can be to `along`, which may be 0. Throws Interrupted.
Eigenpair largest_eigenpair(const LinearMap& matrix, const Eigen::VectorXd& along, double accuracy);

/// The method of Lanczos with full reorthogonalisation (Golub, Van Loan, Matrix Computations, 10.1 and 10.3), from a
/// fixed start vector. For a matrix of up to 300 rows the iteration is completed.
Eigenpairs lanczos(const LinearMap& matrix, Eigen::Index size);

/// A scene linearised at its start, or where its particles are at another moment: u'' = -K u - gamma u' for small
/// displacements u of its moving particles. -K is the Jacobian of the accelerations, exact from dual numbers.
class LinearisedScene {
public:
    LinearisedScene(const Plan& scene, const Shape& shape);
    /// At these displacements from the reference positions.
    LinearisedScene(const Plan& scene, const Shape& shape, Field<double> displacement);

    /// Number of elements of u: three for each moving particle.
    Eigen::Index size() const { return static_cast<Eigen::Index>(moving_.size()); }
    /// K u.
    Eigen::VectorXd stiffness(const Eigen::VectorXd& u) const;
    /// K weighs displacements by the roots of the masses, so that it is symmetric: u as a field of all particles, and
    /// back; fixed ones have none.
    Field<double> field(const Eigen::VectorXd& u) const;
    Eigen::VectorXd vector(const Field<double>& displacements) const;
    /// The displacements [m] that u stands for: without the weights.
    Field<double> displacements(const Eigen::VectorXd& u) const;
    /// u of displacements or velocities, with the weights.
    Eigen::VectorXd weighted(const Field<double>& displacements) const;

private:
    using Number = Dual<double>;

    Field<double> place_;              ///< where it is linearised
    std::vector<std::size_t> moving_;  ///< places in Field::flat()
    std::vector<double> roots_;        ///< of the masses, which make the matrix symmetric
    std::function<void(const Field<Number>&, Field<Number>&)> accelerations_;
};

/// The modes of a linearised scene: eigenvalues omega^2 of K. A negative one means an unstable equilibrium.
Eigenpairs modes(const LinearisedScene& scene);
/// The same from the whole matrix: all of them, degenerate ones as often as they are there. Takes the third power of
/// the number of particles.
Eigenpairs all_modes(const LinearisedScene& scene);
/// How many of the ascending eigenvalues are no vibrations: those that rounding leaves of zero, and those of unstable
/// directions.
Eigen::Index count_of_still(const Eigen::VectorXd& values);
/// The largest angular frequency; 0 if nothing oscillates, infinity if it is beyond what a number holds.
double highest_frequency(const Eigenpairs& modes);
/// Throws UsageError for a scene with a higher frequency than largest_frequency.
void check_stiffness(double omega);

}  // namespace steplab
