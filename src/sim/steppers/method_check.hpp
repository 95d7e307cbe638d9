#pragma once

#include "core/entry.hpp"
#include "methods/engines/erased_force.hpp"
#include "methods/engines/integrator.hpp"
#include "methods/engines/system.hpp"

#include <concepts>

namespace steplab {

/// What src/methods/<id>.hpp must define: `info`, and an integrator of float and double. Checked for every method of
/// the list, so that a member or a capability that is misspelt does not compile.
template <class Method>
concept MethodOfCatalogue = std::same_as<decltype(Method::info), const MethodInfo> &&
                            IntegratorOf < typename Method::template Integrator<float>,
float, System < float,
    ErasedForce < float >>>
        &&IntegratorOf<typename Method::template Integrator<double>, double, System<double, ErasedForce<double>>>;

/// Methods that compute the runs of an ensemble in SIMD lanes.
template <class Method>
inline constexpr bool goes_in_lanes = Method::template Integrator<double>::capabilities.lanes;

}  // namespace steplab
