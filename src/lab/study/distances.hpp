#pragma once

#include "core/field.hpp"

#include <vector>

namespace steplab {

// How far two states of one scene are apart.

/// Squared distances of the particles.
std::vector<double> squared_distances(const Field<double>& a, const Field<double>& b);
/// The largest distance of a particle; infinite if one is not a number.
double largest_distance(const Field<double>& a, const Field<double>& b);
/// The same of positions in long double, computed before rounding to double.
double largest_distance(const State<long double>& a, const State<long double>& b);

/// What rounding to double has changed these numbers by at most: half an ulp of the largest.
double rounding_of(const Field<double>& field);

}  // namespace steplab
