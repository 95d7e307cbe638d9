#pragma once

#include "session/run_view.hpp"

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace steplab {

/// Views of runs beside one that stands at this time, each at its step there (step_at()). Throws Interrupted.
std::vector<RunView> views_at(double time, std::span<const RunDescription> runs, std::optional<std::size_t> tracked);

/// Throws an error with code `diverged` that names the runs that did, if any; the leading one is number 0.
void check_ends(const RunView& leading, const std::vector<RunView>& followers);

}  // namespace steplab
