#pragma once

#include "core/team.hpp"
#include "sim/execution.hpp"

#include <algorithm>
#include <cstddef>
#include <functional>

namespace steplab {

/// f(i, execution) for each i below `count`, in their order but side by side on all processors of the machine: runs
/// made by `execution` leave the others theirs. Once one has thrown, no further one is begun, and the first exception
/// is thrown on.
inline void side_by_side(std::size_t count, const std::function<void(std::size_t, const Execution&)>& f) {
    const std::size_t members = std::clamp<std::size_t>(count, 1, processors());
    const Execution execution{.threads = processors() / members};
    Team(members).share(count, [&](std::size_t i) { f(i, execution); });
}

}  // namespace steplab
