#pragma once

#include "core/entry.hpp"
#include "core/field.hpp"
#include "methods/compensated.hpp"
#include "methods/kick_drift.hpp"

#include <cstddef>
#include <cstdint>
#include <utility>

namespace steplab {

/// The three-point rule x(n+1) = 2 x(n) - x(n-1) + h^2 a(n) in substeps of h, kept as position and mean velocity
/// w = (x(n) - x(n-1)) / h of the last interval, so that near-equal positions are never subtracted (increment form,
/// Press et al., Numerical Recipes, 17.4). Drag enters central in time: with f = gamma h / 2,
/// w' = ((1 - f) w + h a) / (1 + f), x' = x + h w', from w' = (1 - f) v + h/2 a in the first one. The velocity at x is
/// v = (w + h/2 a) / (1 + f).
template <class T>
class ThreePoint {
public:
    /// Every lane of a number type T that has lanes goes its own way.
    static constexpr bool goes_in_lanes = true;

    ThreePoint(const ParameterValues& values, std::size_t substeps)
        : substeps_(substeps), compensated_(asks_for_compensated_sums(values)) {}

    template <class System>
    void start(System& system, State<T> state) {
        steps_ = KickDriftSteps<T>(substep(system.dt() / static_cast<T>(substeps_), system.drag()), std::move(state),
                                   compensated_);
    }

    template <class System>
    void step(System& system) {
        advance(system, 1);
    }
    template <class System>
    void advance(System& system, std::uint64_t steps) {
        steps_.advance(system, steps * substeps_);
    }

    template <class System>
    void synchronised(const System& system, State<T>& out) const {
        steps_.synchronised(system, out);
    }
    template <class System, class Sink>
    void look(const System& system, Sink sink) const {
        steps_.look(system, sink);
    }

    std::size_t reach() const { return substeps_ * steps_.reach(); }

    template <class Self, class F>
    static void each_part(Self& self, F f) {
        KickDriftSteps<T>::each_part(self.steps_, f);
    }

    using Progress = typename KickDriftSteps<T>::Progress;
    Progress progress() const { return steps_.progress(); }
    void progress(const Progress& progress) { steps_.progress(progress); }

private:
    static KickDriftStep<T> substep(T h, T drag) {
        const T f = drag * h / T(2), half = h / T(2);
        return {.parts = {{.gain = h / (T(1) + f), .loss = T(2) * f / (T(1) + f), .drift = h}},
                .lead = T(0),
                .first = {.gain = half, .loss = f, .drift = h},
                .rest = {.gain = half / (T(1) + f), .loss = f / (T(1) + f), .drift = T(0)}};
    }

    KickDriftSteps<T> steps_;
    std::size_t substeps_;
    bool compensated_;
};

}  // namespace steplab
