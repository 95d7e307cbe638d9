#pragma once

#include "methods/engines/erased_force.hpp"
#include "models/forces/forces.hpp"

namespace steplab {

/// The engine of a scene's forces behind one face; T is float or double.
template <class T>
ErasedForce<T> erased_force(const Forces& forces);
// erased_forces.cpp
extern template ErasedForce<float> erased_force(const Forces&);
extern template ErasedForce<double> erased_force(const Forces&);

}  // namespace steplab
