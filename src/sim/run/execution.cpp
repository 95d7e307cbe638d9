#include "sim/run/execution.hpp"

#include "sim/catalogue.hpp"

#include <variant>

namespace steplab {

namespace {

/// Three registers of 32 bytes in double (docs/performance.md, "What bounds it").
constexpr std::size_t few = 12;

std::size_t particles_with_springs(const LineForces& forces) { return forces.count; }
std::size_t particles_with_springs(const GridForces& forces) { return forces.rows * forces.columns; }
template <class Other>
std::size_t particles_with_springs(const Other&) {
    return 0;
}

bool has_few_springs(const Plan& scene) {
    const auto particles = std::visit([](const auto& forces) { return particles_with_springs(forces); }, scene.forces);
    return particles > 0 && particles <= few;
}

bool wide_divisions_take_longer() {
#if defined(__x86_64__)
    return __builtin_cpu_is("intel") != 0;
#else
    return false;
#endif
}

}  // namespace

Instructions instructions_of(const Execution& execution) {
    return execution.instructions.value_or(fastest_instructions());
}

Instructions instructions_for(const Method& method, const Plan& scene, const Execution& execution) {
    const Instructions fastest = instructions_of(execution);
    if (execution.instructions || fastest != Instructions::avx512) return fastest;
    if (!wide_divisions_take_longer() || !has_few_springs(scene) || !method.runs_in_lanes(fastest)) return fastest;
    const auto here = instructions_here();
    return here.size() > 1 ? here[here.size() - 2] : fastest;
}

}  // namespace steplab
