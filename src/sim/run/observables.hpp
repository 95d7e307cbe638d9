#pragma once

#include "core/field.hpp"
#include "models/plan.hpp"

#include <optional>
#include <string_view>
#include <vector>

namespace steplab {

/// A quantity of statistical mechanics, of all moving particles of a scene.
enum class Observable {
    kT,  ///< [J] twice the kinetic energy by the degrees of freedom: 3 n; 3 n - 3 about the centre of mass where no
         ///< particle is fixed
    pressure,  ///< [Pa] (n kT + W / 3) / V by the virial W of all interactions; none without a box along all three axes
    msd,       ///< [m^2] mean squared displacement since the first state that was measured
};

std::string_view id(Observable observable);
/// From a list such as "kT,msd". Throws UsageError naming the known ones.
std::vector<Observable> parse_observables(std::string_view list);

/// Measures states of one scene.
class Observables {
public:
    Observables(Plan scene, std::vector<Observable> wanted);

    const std::vector<Observable>& wanted() const { return wanted_; }
    /// One for each that is wanted; none where it is not defined.
    std::vector<std::optional<double>> of(const State<double>& state);

private:
    double mass(std::size_t i) const { return scene_.mass * (scene_.masses.empty() ? 1 : scene_.masses[i]); }
    std::optional<double> kT(const Field<double>& velocity) const;
    std::optional<double> pressure(const State<double>& state) const;
    double mean_squared_displacement(const Field<double>& displacement);

    Plan scene_;
    std::vector<Observable> wanted_;
    std::vector<std::size_t> moving_;
    std::optional<Field<double>> first_;  ///< displacements
};

/// The virial of all interactions, the sum of r . F over pairs, in J.
double virial(const Forces& forces, const Field<double>& displacement);

}  // namespace steplab
