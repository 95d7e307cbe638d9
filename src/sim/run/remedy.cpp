#include "sim/run/remedy.hpp"

#include "core/ticks.hpp"
#include "sim/catalogue.hpp"
#include "sim/run/resolution.hpp"
#include "sim/run/start_frequency.hpp"

#include <algorithm>
#include <array>

namespace steplab {
namespace {

// A nonlinear scene stiffens as it moves: a run close to its linear limit is no remedy.
constexpr double share_of_limit = 0.9;
/// Of dt; a smaller one would be no remedy that a person can wait for.
constexpr double smallest_part = 1e-3;

/// Judges runs of one scene.
class Judge {
public:
    Judge(double omega_max, const Plan& scene) : omegas_{omega_max, start_frequency(scene)} {}

    bool accepts(const RunDescription& run) const {
        const auto limit = stability_limit(run);
        if (!limit || run.dt > share_of_limit * limit->limit) return false;
        return std::all_of(omegas_.begin(), omegas_.end(), [&](double omega) {
            const auto treated = resolution(run, omega);
            return !treated || treated->keeps_motion();
        });
    }

private:
    std::array<double, 2> omegas_;
};

/// A remedy keeps the kind of method: explicit, in steps of dt.
bool is_of_the_kind(const MethodInfo& info) { return !info.curiosity && !info.implicit && !info.adaptive; }

std::optional<std::string> other_method(const RunDescription& run, const Judge& judge) {
    std::optional<std::string> best;
    double best_cost = infinity;
    for (const Method& entry : methods()) {
        if (!is_of_the_kind(entry.info) || entry.info.id == run.method) continue;
        const RunDescription candidate = with_method(run, entry.info.id);
        const double cost = evaluations_per_step(entry.info, candidate.method_parameters);
        if (cost >= best_cost || !judge.accepts(candidate)) continue;
        best = candidate.method;
        best_cost = cost;
    }
    return best;
}

/// The largest nice dt that is accepted: at most half the limit, and a quarter of a dt that is not beyond it.
std::optional<double> smaller_dt(RunDescription run, double limit, const Judge& judge) {
    const double least = smallest_part * run.dt;
    run.dt = nice_floor(limit > 0 && run.dt >= limit ? limit / 2 : run.dt / 4);
    while (run.dt >= least && !judge.accepts(run)) run.dt = nice_below(run.dt);
    return run.dt >= least ? std::optional(run.dt) : std::nullopt;
}

}  // namespace

Remedies remedies(const RunDescription& run, const Plan& scene) {
    if (chooses_its_steps(run)) return {};
    if (run.dt < 0) {  // what is stable forward in time is so backward
        RunDescription forward = run;
        forward.dt = -run.dt;
        Remedies found = remedies(forward, scene);
        if (found.dt) found.dt = -*found.dt;
        return found;
    }
    const auto limit = stability_limit(run);
    const bool fails_always = method(run.method).info.curiosity;
    if (!limit) return {fails_always ? std::nullopt : std::optional(nice_floor(run.dt / 4)), std::nullopt};
    const Judge judge(limit->omega_max, scene);
    return {fails_always ? std::nullopt : smaller_dt(run, limit->limit, judge), other_method(run, judge)};
}

}  // namespace steplab
