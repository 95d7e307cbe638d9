#pragma once

#include "core/entry.hpp"
#include "core/team.hpp"
#include "sim/run/execution.hpp"
#include "sim/run/memory.hpp"

#include <algorithm>
#include <cstddef>
#include <functional>

namespace steplab {

/// Calls f(i, execution) for each i < `count`, in order and in parallel on all processors, as far as memory allows if
/// each call takes this number of bytes; `execution` limits the threads of a run so that all calls get a share. After
/// an exception no further call begins, and the first exception is rethrown.
inline void parallel_for_each(std::size_t count, double bytes,
                              const std::function<void(std::size_t, const Execution&)>& f) {
    const double room = bytes < 1e6 ? infinity : available_memory() / bytes;  // the query takes longer than small runs
    const auto most = static_cast<std::size_t>(std::clamp(room, 1.0, static_cast<double>(processors())));
    const std::size_t members = std::clamp<std::size_t>(count, 1, most);
    const Execution execution{.threads = processors() / members};
    Team(members).share(count, [&](std::size_t i) { f(i, execution); });
}

}  // namespace steplab
