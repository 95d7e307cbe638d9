#pragma once

#include <vector>

namespace steplab {

/// A kick v += kick dt a(x) and the drift x += drift dt v after it (McLachlan, Quispel, Acta Numerica 11 (2002) 341,
/// section 3). Each kick costs one evaluation. A table begins with a kick, or with a drift alone; it ends with a drift,
/// or, if it begins with a kick, with a kick alone, which then is one with the next step's first.
struct KickAndDrift {
    long double kick = 0;
    long double drift = 0;
};

/// A stage of an explicit Runge-Kutta method each of whose stages starts along the slope of the one before alone.
template <class T>
struct RungeKuttaStage {
    T weight{};          ///< of its slope at the end of the step
    T ahead{};           ///< how far along its slope the next stage starts, in steps
    bool counts = true;  ///< its weight is not zero
};

/// A step as data, of the methods that are a table of kicks and drifts or of such stages; empty for all others.
struct StepParts {
    std::vector<KickAndDrift> kicks;
    bool explicit_drag = false;  ///< kicks take drag as at their beginning; otherwise they solve it exactly
    std::vector<RungeKuttaStage<double>> stages;

    bool known() const { return !kicks.empty() || !stages.empty(); }
};

/// Of a class of src/methods.
template <class Method>
StepParts step_parts() {
    constexpr bool has_kicks = requires { Method::table.front().kick; };
    constexpr bool has_stages = requires { Method::template Integrator<double>::stages_of_steps(); };
    constexpr bool explicit_drag = requires { Method::explicit_drag; };
    StepParts parts;
    parts.explicit_drag = explicit_drag;
    if constexpr (has_kicks) parts.kicks.assign(Method::table.begin(), Method::table.end());
    if constexpr (has_stages) parts.stages = Method::template Integrator<double>::stages_of_steps();
    return parts;
}

}  // namespace steplab
