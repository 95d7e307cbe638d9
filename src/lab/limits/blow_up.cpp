#include "lab/limits/blow_up.hpp"

#include "core/interruption.hpp"
#include "lab/limits/remedy_trial.hpp"
#include "lab/limits/replayed_run.hpp"
#include "sim/catalogue.hpp"
#include "sim/run/remedy.hpp"

#include <algorithm>
#include <cmath>
#include <exception>
#include <utility>

namespace steplab {

namespace {

/// Energy measurements of one pass over a range of steps.
constexpr std::uint64_t measurements = 1024;
/// An excess of energy that belongs to no usable run, as part of the energy at its start.
constexpr double excess = 0.01;
/// Steps over which the growth of the excess is measured.
constexpr std::uint64_t fewest_growing = 4;
/// By how much the factors of its halves may differ: else it is the swing within a period, or the first kick.
constexpr double equal_growth = 1.5;
/// Moments between the last good energy and the end whose oscillations are compared.
constexpr std::uint64_t compared_moments = 16;
/// The cheapest ones that may work.
constexpr std::size_t most_methods = 4;

double scale_of(const Diagnostics& diagnostics) { return diagnostics.kinetic + std::abs(diagnostics.potential); }

/// Of these displacements in the kinetic energy of a state.
double share_of(const FastestOscillation& oscillation, const Plan& scene, const State<double>& state) {
    double along = 0, shape = 0, all = 0;
    for (std::size_t i = 0; i < oscillation.shape.size(); ++i) {
        const double mass = scene.masses.empty() ? 1 : scene.masses[i];
        const Vec3 v = state.velocity.at(i), u = oscillation.shape[i];
        along += mass * dot(v, u);
        shape += mass * dot(u, u);
        all += mass * dot(v, v);
    }
    return shape > 0 && all > 0 ? along * along / (shape * all) : 0;
}

/// An excess of energy that was measured [J].
struct Excess {
    std::uint64_t step = 0;
    double energy = 0;
};

double factor_per_step(const Excess& from, const Excess& to) {
    return std::pow(to.energy / from.energy, 1 / static_cast<double>(to.step - from.step));
}

/// The factor with which it grew from step to step; none if these are few, or if it did not grow evenly.
std::optional<double> growth_of(std::span<const Excess> seen) {
    if (seen.size() < 3 || seen.back().step - seen.front().step < fewest_growing) return std::nullopt;
    const Excess& middle = seen[seen.size() / 2];
    const double early = factor_per_step(seen.front(), middle), late = factor_per_step(middle, seen.back());
    const double all = factor_per_step(seen.front(), seen.back());
    if (!(all > 1) || !std::isfinite(all) || early > equal_growth * late || late > equal_growth * early)
        return std::nullopt;
    return all;
}

/// dt over the limit; how long a step is for the scene.
double ratio(const RunDescription& run, const PresentLimit& limit) {
    if (!limit.limit || std::isinf(*limit.limit)) return 0;
    return *limit.limit > 0 ? std::abs(run.dt) / *limit.limit : infinity;
}

}  // namespace

struct BlowUpStudy::Body {
    ReplayedRun replay;
    PresentLimits limits;
    BlowUp found;
    std::optional<ReplayedRun::Moment> good;  ///< the last one before the energy left its range
    std::uint64_t good_evaluations = 0;       ///< up to it
    double good_time = 0;                     ///< of it
    std::optional<RemedyTrial> trial;
    std::vector<RunDescription> dts, methods;  ///< to be tried yet, the next one last
    std::vector<RunDescription> last_resorts;  ///< methods of other kinds, if none of these works
    State<double> start_state;
    double baseline = 0, least_baseline = 0;  ///< size of the energy there [J]
    std::optional<std::uint64_t> baseline_step;

    Body(std::span<const SegmentBegin> changes, const Divergence& divergence, std::vector<ReplayedRun::Moment> kept)
        : replay(changes, std::move(kept)), start_state(run().state()) {
        found.divergence = divergence;
    }

    const Simulation& run() const { return replay.run(); }
    bool can_be_linearised() const { return run().particles() <= PresentLimits::most_particles; }

    PresentLimit here() {
        if (can_be_linearised()) return limits.at(run().description(), run().state(), run().step(), run().time());
        PresentLimit known{.step = run().step(), .time = run().time()};
        if (run().limit()) known.limit = run().limit()->limit, known.oscillation.omega = run().limit()->omega_max;
        known.resolution = run().resolution();
        return known;
    }

    /// Of the scene as it stood at its start, with the parameters, method and dt with which the run diverged.
    PresentLimit at_start() { return can_be_linearised() ? limits.at(found.run, start_state, 0, 0) : here(); }

    void find_cause() {
        find_last_good();
        found.step = run().step();
        found.time = run().time();
        measure_growth();
        replay.go_back_to(*good);
        find_limit();
        replay.go_to(found.divergence.step);
        found.run = run().description();
        found.start = at_start();
        find_limit_on_last_way();
        if (can_be_linearised())
            found.share = share_of(found.limit.oscillation, limits.plan(run().description()), run().state());
        prepare_trials();
        found.why = explanation_of(found);
    }

    /// Leaves the run at the last step before its energy left the range of its start for good.
    void find_last_good() {
        replay.go_to(found.divergence.step);
        // an error is possible up to 1000 times the size of the energy, which may be 0 at the start (divergence.md)
        least_baseline = std::max(run().energy_error() / 1000, 0.0);
        replay.go_back_to_last(found.divergence.step, [this] { return is_good(); });
        std::uint64_t stride = std::max<std::uint64_t>(1, (found.divergence.step - run().step()) / measurements);
        good = replay.moment();
        measure_up_to(found.divergence.step, stride);
        while (stride > 1) {
            replay.go_back_to(*good);
            const std::uint64_t end = std::min(found.divergence.step, run().step() + stride);
            stride = std::max<std::uint64_t>(1, stride / measurements);
            measure_up_to(end, stride);
        }
        replay.go_back_to(*good);
        good_evaluations = run().evaluations();
        good_time = run().time();
    }

    /// The energy is in the range of its baseline.
    bool is_good() {
        measure_baseline();
        return run().energy_error() <= excess * baseline;
    }

    void measure_baseline() {
        if (baseline_step == run().baseline_step()) return;
        baseline_step = run().baseline_step();
        const ReplayedRun::Moment here = replay.moment();
        if (run().step() != *baseline_step) replay.go_to(*baseline_step);
        baseline = std::max(scale_of(run().diagnostics()), least_baseline);
        replay.go_back_to(here);
    }

    /// From where the run stands; what is good on the way is remembered.
    void measure_up_to(std::uint64_t end, std::uint64_t stride) {
        while (true) {
            if (is_good()) good = replay.moment();
            if (run().step() >= end || run().divergence()) return;
            replay.advance_to(std::min(end, run().step() + stride));
        }
    }

    /// From the first step of too much energy until the excess is as large as the energy itself: before the motion
    /// becomes another.
    void measure_growth() {
        const std::uint64_t end = found.divergence.step, stride = 1 + (end - found.step) / measurements;
        std::vector<Excess> seen;
        while (run().step() < end && !run().divergence() && run().energy_error() < baseline) {
            replay.advance_to(std::min(end, run().step() + stride));
            if (run().energy_error() > excess * baseline) seen.push_back({run().step(), run().energy_error()});
        }
        found.growth = growth_of(seen);
    }

    /// At the first moment at which dt is beyond the limit, or that at which it is nearest to it.
    void find_limit() {
        const std::uint64_t begin = run().step(), steps = found.divergence.step - begin;
        for (std::uint64_t i = 0; i <= compared_moments; ++i) {
            const std::uint64_t step = begin + steps * i / compared_moments;
            if (i > 0 && step == run().step()) continue;
            replay.advance_to(step);
            const PresentLimit limit = here();
            if (i == 0 || limit.oscillation.omega > found.limit.oscillation.omega) found.limit = limit;
            if (ratio(run().description(), found.limit) > 1 || !can_be_linearised()) break;
        }
    }

    /// Particles may pass through in one step what no step shows: along their straight ways from the last valid one.
    void find_limit_on_last_way() {
        if (!can_be_linearised() || ratio(run().description(), found.limit) > 1) return;
        State<double> state = run().state();
        for (std::uint64_t i = 1; i <= compared_moments && ratio(run().description(), found.limit) <= 1; ++i) {
            const double part = run().dt() / static_cast<double>(compared_moments);
            for (std::size_t k = 0; k < state.displacement.flat().size(); ++k)
                state.displacement.flat()[k] += part * state.velocity.flat()[k];
            const double time = run().time() + static_cast<double>(i) * part;
            const PresentLimit limit = limits.at(run().description(), state, run().step(), time);
            if (limit.oscillation.omega > found.limit.oscillation.omega) found.limit = limit;
        }
    }

    /// Force evaluations per simulated second of the method and dt with which the run diverged; before it may have had
    /// others. Where a method decides itself how many it takes, those since the last good moment.
    double cost() const {
        const RunDescription& now = run().description();
        const MethodInfo& info = method(now.method).info;
        const double time = std::abs(run().time() - good_time);
        if ((info.adaptive || info.implicit) && time > 0)
            return static_cast<double>(run().evaluations() - good_evaluations) / time;
        return evaluations_per_step(info, now.method_parameters) / std::abs(now.dt);
    }

    void prepare_trials() {
        const RunDescription& now = run().description();
        trial.emplace(good->snapshot, now, std::abs(run().time()), cost());
        if (found.divergence.stop) return;
        // how far the scene stiffens is for the trials to find
        const double omega =
            found.start.oscillation.omega > 0 ? found.start.oscillation.omega : found.limit.oscillation.omega;
        RemedyCandidates candidates = remedy_candidates(now, limits.plan(now), omega);
        for (const double dt : candidates.dts) {
            dts.push_back(now);
            dts.back().dt = dt;
        }
        if (candidates.methods.size() > most_methods) candidates.methods.resize(most_methods);
        for (const std::string& id : candidates.methods) methods.push_back(with_method(now, id));
        std::reverse(dts.begin(), dts.end());
        std::reverse(methods.begin(), methods.end());
        prepare_last_resorts();
    }

    /// Implicit methods, which have no limit, then those that choose their steps.
    void prepare_last_resorts() {
        const RunDescription& now = run().description();
        for (const bool adaptive : {false, true}) {
            for (const Method& other : steplab::methods()) {
                const MethodInfo& info = other.info;
                if (info.curiosity || info.id == now.method || info.adaptive != adaptive) continue;
                if (adaptive || info.implicit) last_resorts.push_back(with_method(now, info.id));
            }
        }
        std::reverse(last_resorts.begin(), last_resorts.end());
    }

    bool has_remedy() const {
        return std::any_of(found.tried.begin(), found.tried.end(),
                           [](const TriedRemedy& tried) { return tried.works; });
    }
    bool needs_last_resort() const { return !last_resorts.empty() && !has_remedy(); }

    /// One of these; the rest is not needed once one works.
    void try_next(std::vector<RunDescription>& candidates) {
        const RunDescription candidate = std::move(candidates.back());
        candidates.pop_back();
        try {
            found.tried.push_back(trial->of(candidate));
        } catch (const Interrupted&) {
            throw;
        } catch (const std::exception&) {  // the method refuses the scene, or there is no memory for another run of it
            return;
        }
        if (found.tried.back().works) candidates.clear();
    }
};

BlowUpStudy::BlowUpStudy(std::span<const SegmentBegin> changes, const Divergence& divergence,
                         std::vector<ReplayedRun::Moment> kept)
    : body_(std::make_unique<Body>(changes, divergence, std::move(kept))) {}

BlowUpStudy::~BlowUpStudy() = default;
BlowUpStudy::BlowUpStudy(BlowUpStudy&&) noexcept = default;
BlowUpStudy& BlowUpStudy::operator=(BlowUpStudy&&) noexcept = default;

bool BlowUpStudy::next() {
    if (!body_->trial) {
        body_->find_cause();
    } else if (!body_->dts.empty()) {
        body_->try_next(body_->dts);
    } else if (!body_->methods.empty()) {
        body_->try_next(body_->methods);
    } else if (body_->needs_last_resort()) {
        body_->try_next(body_->last_resorts);
    }
    body_->found.complete = body_->dts.empty() && body_->methods.empty() && !body_->needs_last_resort();
    return !body_->found.complete;
}

const BlowUp& BlowUpStudy::found() const { return body_->found; }

std::uint64_t BlowUpStudy::steps() const { return body_->replay.steps(); }

}  // namespace steplab
