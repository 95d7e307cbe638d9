#pragma once

#include "core/interval.hpp"
#include "core/pair_approach.hpp"
#include "models/potentials/expression_potential.hpp"

#include <vector>

namespace steplab {

/// Least and largest masses and charges of the pairs of a term.
using RangeOfPairs = PairProperties<Interval>;

/// Where a pair force that was typed does more than at both ends of a step of its table: bounds of its values over the
/// step say whether it can, and the step is halved until they are near to values. `cutoff`: 0: none. Takes a
/// millisecond or two, of forces that change everywhere within steps some more.
std::vector<HiddenStretch> hidden_stretches(const ExpressionForce& force, const RangeOfPairs& pairs, double cutoff);

}  // namespace steplab
