#pragma once

#include "models/forces/composition.hpp"
#include "models/scene/scene.hpp"

#include <memory>
#include <span>
#include <string>
#include <string_view>

namespace steplab {

// Potentials that are written as expressions. The variables of a pair force are r, m1, m2, q1, q2, those of a field x,
// y, z, m, q; other names are values of the term or parameters. The functions below throw ExpressionError for what is
// no expression, and UsageError for one that is too long or has unknown names.

std::span<const std::string_view> variables_of_pairs();
std::span<const std::string_view> variables_of_fields();

/// Masses, energies and forces in units of the mass `unit`.
std::shared_ptr<const ExpressionForce> expression_of(const PairTerm& term, double unit);
/// Without particles.
ComposedField expression_of(const FieldTerm& term, double unit);

}  // namespace steplab
