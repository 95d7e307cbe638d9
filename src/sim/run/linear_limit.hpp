#pragma once

#include "sim/catalogue.hpp"
#include "sim/run/run_description.hpp"

#include <array>
#include <complex>

namespace steplab {

/// The largest stable dt of a method on x'' = -omega^2 x - gamma x', found from the matrix that one of its steps makes
/// of (x, v): it is stable while no eigenvalue is larger than 1 in size. Infinity if omega = gamma = 0. Without drag it
/// is the entry's linear_limit over omega. The curiosities, which are unstable in other ways, are not asked: they get
/// the limit without drag, as do the adaptive ones, whose steps follow the motion.
double linear_limit(const Method& method, const ParameterValues& parameters, double omega, double gamma);

/// The largest stable omega dt on x'' = -omega^2 x as found in the same way, whatever the entry says: 0 if it grows at
/// 0.01 already.
double measured_linear_limit(const Method& method, const ParameterValues& parameters);

/// That of a run whose scene's fastest oscillation has this frequency [rad/s], with the scene's drag: of this
/// oscillation and of motion that nothing drives back. 0: unstable at any dt.
double linear_limit(const RunDescription& run, double omega);

/// The eigenvalues of that matrix for a step of dt.
std::array<std::complex<double>, 2> step_eigenvalues(const Method& method, const ParameterValues& parameters,
                                                     double omega, double gamma, double dt);

/// The factor by which a step of dt lets that motion grow: the size of the matrix' larger eigenvalue.
double step_growth(const Method& method, const ParameterValues& parameters, double omega, double gamma, double dt);

}  // namespace steplab
