#include "sim/run/remedy.hpp"

#include "core/ticks.hpp"
#include "sim/catalogue.hpp"
#include "sim/run/linear_limit.hpp"
#include "sim/run/resolution.hpp"
#include "sim/run/start_frequency.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace steplab {

namespace {

// A nonlinear scene stiffens as it moves: a run close to its linear limit is no remedy.
constexpr double share_of_limit = 0.9;
/// Of dt; a smaller one would be no remedy that a person can wait for.
constexpr double smallest_part = 1e-3;
/// Each is half of the one before, or less.
constexpr std::size_t most_dts = 6;

/// Judges runs of one scene.
class Judge {
public:
    Judge(double omega, const Plan& scene) : omegas_{omega, start_frequency(scene)} {}

    bool accepts(const RunDescription& run) const {
        if (run.dt > share_of_limit * linear_limit(run, omegas_[0])) return false;
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

std::vector<std::string> other_methods(const RunDescription& run, const Judge& judge) {
    std::vector<std::pair<double, std::string>> accepted;
    for (const Method& entry : methods()) {
        if (!is_of_the_kind(entry.info) || entry.info.id == run.method) continue;
        const RunDescription candidate = with_method(run, entry.info.id);
        if (!judge.accepts(candidate)) continue;
        accepted.emplace_back(evaluations_per_step(entry.info, candidate.method_parameters), candidate.method);
    }
    std::stable_sort(accepted.begin(), accepted.end(),
                     [](const auto& one, const auto& other) { return one.first < other.first; });
    std::vector<std::string> ids;
    ids.reserve(accepted.size());
    for (auto& [cost, id] : accepted) ids.push_back(std::move(id));
    return ids;
}

/// Nice ones: the first at most half the limit, and a quarter of a dt that is not beyond it.
template <class Accepts>
std::vector<double> smaller_dts(RunDescription run, double limit, const Accepts& accepts) {
    std::vector<double> dts;
    const double least = smallest_part * run.dt;
    run.dt = nice_floor(limit > 0 && run.dt >= limit ? limit / 2 : run.dt / 4);
    for (; run.dt >= least && dts.size() < most_dts; run.dt = nice_below(run.dt)) {
        if (accepts(run)) dts.push_back(run.dt);
    }
    return dts;
}

}  // namespace

RemedyCandidates remedy_candidates(const RunDescription& run, const Plan& scene, double omega) {
    if (chooses_its_steps(run)) return {};
    if (run.dt < 0) {  // what is stable forward in time is so backward
        RunDescription forward = run;
        forward.dt = -run.dt;
        RemedyCandidates found = remedy_candidates(forward, scene, omega);
        for (double& dt : found.dts) dt = -dt;
        return found;
    }
    const bool fails_always = method(run.method).info.curiosity;
    RemedyCandidates found;
    if (!(omega > 0)) {
        if (!fails_always) found.dts = smaller_dts(run, 0, [](const RunDescription&) { return true; });
        return found;
    }
    const Judge judge(omega, scene);
    const auto accepts = [&](const RunDescription& candidate) { return judge.accepts(candidate); };
    if (!fails_always) found.dts = smaller_dts(run, linear_limit(run, omega), accepts);
    found.methods = other_methods(run, judge);
    return found;
}

}  // namespace steplab
