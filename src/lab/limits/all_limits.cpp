#include "lab/limits/all_limits.hpp"

#include "core/error.hpp"
#include "core/watching.hpp"
#include "lab/study/parallel.hpp"
#include "sim/ensemble/ensemble_stepper.hpp"
#include "sim/run/memory.hpp"

#include <algorithm>
#include <mutex>

namespace steplab {

namespace {

Limit limit_or_refusal(const StabilityLab& lab, const RunDescription& run) {
    try {
        return lab.limit(run);
    } catch (const UsageError& refusal) {
        return {.description = run, .omega_max = lab.omega_max(), .theory = {}, .measured = {}, .note = refusal.what()};
    }
}

Limit watched(const StabilityLab& lab, const RunDescription& run, const std::function<void()>& watch) {
    const Watching watching(watch);
    return limit_or_refusal(lab, run);
}

/// Memory of the runs in SIMD lanes of one search; 0 for a run that is not possible.
double bytes_of_search(const RunDescription& run) {
    try {
        return static_cast<double>(most_lanes) * bytes_of_run(run);
    } catch (const UsageError&) {
        return 0;
    }
}

}  // namespace

std::vector<Limit> all_limits(const StabilityLab& lab, std::span<const RunDescription> methods,
                              const std::function<void(std::size_t)>& done) {
    std::vector<Limit> limits(methods.size());
    std::mutex mutex;  // protects found and the calls of done
    std::size_t found = 0;
    double bytes = 0;
    for (const RunDescription& run : methods) bytes = std::max(bytes, bytes_of_search(run));
    parallel_for_each(methods.size(), bytes, [&](std::size_t i, const Execution&) {
        limits[i] = watched(lab, methods[i], [&] {
            const std::lock_guard lock(mutex);
            done(found);
        });
        const std::lock_guard lock(mutex);
        done(++found);
    });
    return limits;
}

}  // namespace steplab
