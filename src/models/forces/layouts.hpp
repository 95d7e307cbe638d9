#pragma once

#include "core/force_layout.hpp"
#include "models/forces/composed.hpp"
#include "models/forces/constant.hpp"
#include "models/forces/grid.hpp"
#include "models/forces/line.hpp"
#include "models/forces/near_pairs.hpp"
#include "models/forces/pairs.hpp"

namespace steplab {

// The engine of each layout of forces, in any number type.

template <class T>
Constant<T> engine(const ConstantForces& forces) {
    return Constant<T>(forces);
}
template <class T>
Line<T> engine(const LineForces& forces) {
    return Line<T>(forces);
}
template <class T>
Grid<T> engine(const GridForces& forces) {
    return Grid<T>(forces);
}
template <class T>
Pairs<T> engine(const PairForces& forces) {
    return Pairs<T>(forces);
}
template <class T>
NearPairs<T> engine(const NearPairForces& forces) {
    return NearPairs<T>(forces);
}
template <class T>
Composed<T> engine(const ComposedForces& forces) {
    return Composed<T>(forces);
}

static_assert(ForceLayout<Constant<float>, float> && ForceLayout<Constant<double>, double>);
static_assert(ForceLayout<Line<float>, float> && ForceLayout<Line<double>, double>);
static_assert(ForceLayout<Grid<float>, float> && ForceLayout<Grid<double>, double>);
static_assert(ForceLayout<Pairs<float>, float> && ForceLayout<Pairs<double>, double>);
static_assert(ForceLayout<NearPairs<float>, float> && ForceLayout<NearPairs<double>, double>);
static_assert(ForceLayout<Composed<float>, float> && ForceLayout<Composed<double>, double>);

}  // namespace steplab
