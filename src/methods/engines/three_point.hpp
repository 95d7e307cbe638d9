#pragma once

#include "core/entry.hpp"
#include "core/field.hpp"
#include "methods/engines/compensated.hpp"
#include "methods/engines/kick_drift.hpp"

#include <cstddef>
#include <utility>

namespace steplab {

/// The three-point rule x(n+1) = 2 x(n) - x(n-1) + h^2 a(n) in substeps of h, kept as position and mean velocity
/// w = (x(n) - x(n-1)) / h of the last interval, so that near-equal positions are never subtracted (increment form,
/// Press et al., Numerical Recipes, 17.4). Drag enters central in time: with f = gamma h / 2,
/// w' = ((1 - f) w + h a) / (1 + f), x' = x + h w', from w' = (1 - f) v + h/2 a in the first one. The velocity at x is
/// v = (w + h/2 a) / (1 + f).
template <class T>
class ThreePoint : public KickDriftSteps<T> {
public:
    ThreePoint(const ParameterValues& values, std::size_t substeps)
        : KickDriftSteps<T>(asks_for_compensated_sums(values)), substeps_(substeps) {}

    template <class System>
    void start(System& system, State<T> state) {
        this->set_step(step_of(system.dt(), system.drag()));
        KickDriftSteps<T>::start(system, std::move(state));
    }

    KickDriftStep<T> step_of(T dt, T drag) const {
        const T h = dt / static_cast<T>(substeps_), f = drag * h / T(2), half = h / T(2);
        return {.parts = {{.gain = h / (T(1) + f), .loss = T(2) * f / (T(1) + f), .drift = h}},
                .lead = T(0),
                .first = {.gain = half, .loss = f, .drift = h},
                .rest = {.gain = half / (T(1) + f), .loss = f / (T(1) + f), .drift = T(0)},
                .times = substeps_};
    }

private:
    std::size_t substeps_;
};

}  // namespace steplab
