#pragma once

#include "core/entry.hpp"
#include "core/team.hpp"
#include "sim/run/execution.hpp"
#include "sim/run/memory.hpp"

#include <algorithm>
#include <cstddef>
#include <functional>

namespace steplab {

/// f(i, execution) for each i below `count`, in their order but side by side on all processors of the machine, as far
/// as memory allows where each takes so many bytes: runs made by `execution` leave the others theirs. Once one has
/// thrown, no further one is begun, and the first exception is thrown on.
inline void parallel_for_each(std::size_t count, double bytes,
                              const std::function<void(std::size_t, const Execution&)>& f) {
    const double room = bytes < 1e6 ? infinity : available_memory() / bytes;  // to ask takes longer than small runs
    const auto most = static_cast<std::size_t>(std::clamp(room, 1.0, static_cast<double>(processors())));
    const std::size_t members = std::clamp<std::size_t>(count, 1, most);
    const Execution execution{.threads = processors() / members};
    Team(members).share(count, [&](std::size_t i) { f(i, execution); });
}

}  // namespace steplab
