#pragma once

#include "core/entry.hpp"
#include "core/field.hpp"
#include "core/phi.hpp"
#include "methods/engines/compensated.hpp"
#include "methods/engines/kick_drift.hpp"
#include "methods/engines/step_parts.hpp"

#include <array>
#include <cstddef>
#include <span>
#include <utility>

namespace steplab {

/// velocity-verlet applied with w[0] dt, w[1] dt, ...; the half kicks between two of them are one.
template <std::size_t N>
constexpr std::array<KickAndDrift, N + 1> composition(const std::array<long double, N>& w) {
    std::array<KickAndDrift, N + 1> table{};
    for (std::size_t i = 0; i < N; ++i) {
        table[i].kick += w[i] / 2;
        table[i].drift = w[i];
        table[i + 1].kick = w[i] / 2;
    }
    return table;
}

/// Runs any splitting method; `Table::table` is its array of KickAndDrift. Drag belongs to the kicks: v' = a - gamma v
/// is solved exactly over each kick's time, v += tau phi_1(-gamma tau) (a - gamma v); a Table with `explicit_drag`
/// takes v += tau (a - gamma v) instead.
template <class T, class Table>
class Splitting : public KickDriftSteps<T> {
public:
    explicit Splitting(const ParameterValues& values) : KickDriftSteps<T>(asks_for_compensated_sums(values)) {}

    template <class System>
    void start(System& system, State<T> state) {
        this->set_step(step_of(system.dt(), system.drag()));
        KickDriftSteps<T>::start(system, std::move(state));
    }

    /// A last kick is one with the first kick of the next step, a last drift with a first drift.
    KickDriftStep<T> step_of(T dt, T drag) const {
        KickDriftStep<T> step;
        std::span<const KickAndDrift> parts = table;
        if (const KickAndDrift lead = parts.front(), rest = parts.back(); lead.kick == 0) {
            for (const KickAndDrift& part : parts.subspan(1)) step.parts.push_back(part_of(part, dt, drag));
            step.parts.back() = part_of({rest.kick, rest.drift + lead.drift}, dt, drag);
            step.lead = static_cast<T>(lead.drift) * dt;
            step.rest.drift = -step.lead;
            step.first = step.parts.front();
        } else if (rest.drift == 0) {
            for (const KickAndDrift& part : parts.first(parts.size() - 1))
                step.parts.push_back(part_of(part, dt, drag));
            step.first = step.parts.front();
            step.parts.front() = part_of({lead.kick + rest.kick, lead.drift}, dt, drag);
            step.rest = part_of(rest, dt, drag);
        } else {
            for (const KickAndDrift& part : parts) step.parts.push_back(part_of(part, dt, drag));
            step.first = step.parts.front();
        }
        return step;
    }

private:
    static constexpr auto& table = Table::table;
    static constexpr bool explicit_drag = requires { Table::explicit_drag; };

    static KickDrift<T> part_of(const KickAndDrift& part, T dt, T drag) {
        const T tau = static_cast<T>(part.kick) * dt, gain = explicit_drag ? tau : tau * phi_1(-drag * tau);
        return {gain, gain * drag, static_cast<T>(part.drift) * dt};
    }
};

}  // namespace steplab
