#pragma once

#include "core/entry.hpp"
#include "methods/engines/adaptive.hpp"
#include "methods/engines/gauss_radau.hpp"

namespace steplab {

/// IAS15, with one step size for the whole scene.
struct Ias15 {
    static constexpr ParameterInfo parameters[] = {[] {
        ParameterInfo tolerance = tolerance_parameter;
        tolerance.what = "allowed error per step, absolute and relative; Rein's epsilon is 265 tolerance^(7/15)";
        return tolerance;
    }()};

    static constexpr MethodInfo info{
        .id = "ias15",
        .name = "IAS15",
        .what = "Adaptive Gauss-Radau method of order 15: accurate to rounding, for small scenes.",
        .order = 15,
        .order_with_drag = 15,
        .order_with_damping = 15,
        .evaluations = 15,  // typically two iterations over seven nodes
        .start_evaluations = 1,
        .linear_limit = infinity,  // the step follows the motion
        .adaptive = true,
        .conserves = "momentum",
        .source = "Rein, Spiegel, MNRAS 446 (2015) 1424; Everhart, in Dynamics of Comets (1985) 185",
        .parameters = parameters,
    };

    template <class T>
    using Integrator = GaussRadau<T>;
};

}  // namespace steplab
