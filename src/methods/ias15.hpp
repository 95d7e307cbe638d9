#pragma once

#include "core/entry.hpp"
#include "methods/engines/adaptive.hpp"
#include "methods/engines/gauss_radau.hpp"

namespace steplab {

/// IAS15, with a step rule of the scene as a whole.
struct Ias15 {
    static constexpr ParameterInfo parameters[] = {[] {
        ParameterInfo tolerance = tolerance_parameter;
        tolerance.what = "error allowed in a step, absolute and relative alike; Rein's epsilon is 265 tolerance^(7/15)";
        return tolerance;
    }()};

    static constexpr MethodInfo info{
        .id = "ias15",
        .name = "IAS15",
        .what = "Gauss-Radau of order 15 that chooses its steps: right to the last digits, for small scenes.",
        .order = 15,
        .order_with_drag = 15,
        .evaluations = 15,  // two passes over seven nodes are usual
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
