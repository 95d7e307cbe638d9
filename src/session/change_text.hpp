#pragma once

#include "sim/ensemble/live_ensemble.hpp"
#include "sim/run/run_description.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace steplab {

/// The names of what differs between two descriptions of one scene: method, precision, dt, parameters.
std::vector<std::string_view> differences(const RunDescription& a, const RunDescription& b);
/// The particles that are altered otherwise in one than in the other, ascending.
std::vector<std::size_t> altered_particles(const RunDescription& a, const RunDescription& b);

/// What a change of a run did, for its time line: "dt 0.2", "method rk4, tolerance 1e-9", "pull of particle 9".
std::string text_of(const SegmentBegin& before, const SegmentBegin& change);

}  // namespace steplab
