#pragma once

#include "core/force_layout.hpp"
#include "models/scene/scene.hpp"

#include <optional>

namespace steplab {

/// Where a pair is bound: a minimum of its energy.
struct PairWell {
    double distance = 0;   ///< [m]
    double stiffness = 0;  ///< V'' there [N/m]
};

/// The minimum of the energy of two particles that is nearest to distance 0, as it is without a cut-off; nullopt where
/// they only attract or only repel each other. Masses in kg, charges in C. Throws UsageError for an expression that is
/// too long.
std::optional<PairWell> pair_well(const PairTerm& term, const PairProperties<double>& properties);

}  // namespace steplab
