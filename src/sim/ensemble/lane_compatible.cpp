#include "sim/ensemble/lane_compatible.hpp"

#include <algorithm>
#include <cstddef>
#include <type_traits>
#include <variant>

namespace steplab {

namespace {

bool lane_compatible(const LineForces& a, const LineForces& b) {
    return a.count == b.count && a.first_fixed == b.first_fixed && (a.gravity == 0) == (b.gravity == 0);
}
bool lane_compatible(const GridForces& a, const GridForces& b) { return a.rows == b.rows && a.columns == b.columns; }
bool lane_compatible(const PairForces& a, const PairForces& b) { return a.count == b.count && a.balance == b.balance; }
/// Layouts that are not computed in lanes.
template <class Forces>
bool lane_compatible(const Forces&, const Forces&) {
    return false;
}

/// Products of these with the numbers of a method are no subnormals, which would be flushed: methods check whether they
/// are zero.
bool comfortable(const StepperSetup& run) {
    constexpr double least = 1e-20;
    return run.dt >= least && (run.scene.drag == 0 || std::min(1.0, run.dt) * run.scene.drag >= least);
}

/// Of four fields of three components that a step goes through, each in the widest register.
constexpr std::size_t bytes_of_particle = 4 * 3 * 64;
constexpr std::size_t most_bytes = std::size_t{1} << 19;
/// A run of more pairs has full registers by itself: its pairs are computed in blocks.
constexpr std::size_t most_in_pairs = 16;

}  // namespace

bool lane_compatible(const StepperSetup& a, const StepperSetup& b) {
    if (a.scene.forces.index() != b.scene.forces.index() || !(a.parameters == b.parameters)) return false;
    if ((a.scene.drag == 0) != (b.scene.drag == 0) || !comfortable(a) || !comfortable(b)) return false;
    return std::visit(
        [&b](const auto& forces) {
            return lane_compatible(forces, std::get<std::remove_cvref_t<decltype(forces)>>(b.scene.forces));
        },
        a.scene.forces);
}

bool fits_lanes(const StepperSetup& run) {
    const std::size_t count = run.scene.reference.count;
    const bool pairs = std::holds_alternative<PairForces>(run.scene.forces);
    return lane_compatible(run, run) && count * bytes_of_particle <= most_bytes && (!pairs || count <= most_in_pairs);
}

}  // namespace steplab
