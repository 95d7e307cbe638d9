#pragma once

#include "core/diagnostics.hpp"
#include "core/field.hpp"
#include "models/layouts.hpp"
#include "models/model.hpp"

#include <variant>

namespace steplab {

/// Kinetic and potential energy of one state, in the parts the check of divergence needs.
struct Energy {
    double kinetic = 0;
    PotentialEnergy potential;

    double total() const { return kinetic + potential.value; }
};

/// Computes sums over a scene's particles in double, from the synchronised state.
class EnergyMeter {
public:
    explicit EnergyMeter(const Scene& scene);

    Energy energy(const State<double>& state);
    /// An energy no run of this scene may be judged by the changes of: rounding, and the depth of potential wells.
    double floor() const { return floor_; }

private:
    using Engine = std::variant<Constant<double>, Line<double>, Grid<double>, Pairs<double>, NearPairs<double>>;

    double mass_;
    Engine engine_;
    double floor_;
};

}  // namespace steplab
