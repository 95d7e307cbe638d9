#include "sim/ensemble/lane_runs.hpp"

#include "core/flush_subnormals.hpp"
#include "core/larger_magnitude.hpp"
#include "sim/catalogue.hpp"
#include "sim/ensemble/lane_compatible.hpp"
#include "sim/run/divergence.hpp"
#include "sim/run/measures.hpp"
#include "sim/run/segment.hpp"
#include "sim/run/simulation_body.hpp"
#include "sim/run/starting.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

namespace steplab {

namespace {

/// One run of a group.
struct Member {
    RunDescription held;
    Plan scene;
    EnergyMeter meter;
    std::uint64_t steps;
    std::shared_ptr<const ExactSolution> exact;  ///< if errors are measured and one is known
    Energy baseline;
    RunResult result;
    bool open = true;       ///< under way
    bool diverged = false;  ///< or may have done so

    Member(const EnsembleRun& run, const Execution& execution)
        : held(as_held(run.description)),
          scene(plan_of(held)),
          meter(scene, instructions_of(execution)),
          steps(run.end.step),
          exact(run.with_errors ? exact_of(held) : nullptr) {}

    StepperSetup setup(const Execution& execution) const {
        return segment_start(held, scene, instructions_of(execution));
    }
};

/// Runs in SIMD lanes, from their start to their ends.
class LaneRuns {
public:
    LaneRuns(std::vector<std::unique_ptr<Member>>& members, EnsembleStepper& group, std::uint64_t every)
        : members_(members), group_(group), every_(every) {
        for (std::size_t run = 0; run < group_.runs(); ++run) {
            members_[run]->baseline = energy(run);
            members_[run]->result.energy_start = members_[run]->baseline.total();
        }
        measure();
    }

    void run(const StepsDone& done) {
        while (const std::size_t open = still_open()) {
            const std::uint64_t next = next_measurement();
            group_.advance(next - step_);
            done((next - step_) * open);
            step_ = next;
            measure();
        }
    }

private:
    std::size_t still_open() const {
        return static_cast<std::size_t>(std::count_if(members_.begin(), members_.begin() + runs(),
                                                      [](const auto& member) { return member->open; }));
    }

    /// The next step at which a run ends, a row is due or the energy is to be judged.
    std::uint64_t next_measurement() const {
        std::uint64_t next = step_ - step_ % steps_between_checks + steps_between_checks;
        next = std::min(next, step_ - step_ % every_ + every_);
        for (std::size_t run = 0; run < group_.runs(); ++run) {
            if (members_[run]->open) next = std::min(next, members_[run]->steps);
        }
        return next;
    }

    void measure() {
        for (std::size_t run = 0; run < group_.runs(); ++run) {
            if (members_[run]->open) measure(run);
        }
    }

    void measure(std::size_t run) {
        Member& member = *members_[run];
        const bool ends = step_ == member.steps, judged = ends || step_ % steps_between_checks == 0;
        if (!group_.finite(run) || (judged && !energy_is_good(run))) {
            member.open = false, member.diverged = true;
            return;
        }
        if (!ends && step_ % every_ != 0) return;
        const double now = energy(run).total();
        member.result.energy_error = larger_magnitude(member.result.energy_error, now - member.baseline.total());
        if (ends) finish(run, now);
    }

    /// For most runs, what the stepper knows of all of them is enough.
    bool energy_is_good(std::size_t run) {
        Member& member = *members_[run];
        const Energy& start = member.baseline;
        const double bound = 2 * member.scene.mass * group_.energy_bound(run);  // twice, for its rounding
        const double floor = member.meter.floor(member.held.dt);
        return energy_is_surely_possible(bound, start, floor) || energy_is_possible(energy(run), start, floor);
    }

    void finish(std::size_t run, double energy_end) {
        Member& member = *members_[run];
        RunResult& result = member.result;
        result.dt = member.held.dt;
        result.steps = step_;
        result.time = static_cast<double>(step_) * member.held.dt;
        result.particles = member.scene.reference.count;
        result.evaluations = group_.evaluations();
        result.energy_end = energy_end;
        const auto emit = [&](const PortionSink& sink) { show(run, sink); };
        result.farthest = farthest_of(emit);
        if (member.exact && result.time <= member.exact->valid_until())  // of what was shown just now
            result.error = largest_error(seen_.displacement, *member.exact, result.time);
        result.hash = hash_of(step_, member.held.precision, emit);
        member.open = false;
    }

    Energy energy(std::size_t run) {
        return members_[run]->meter.energy([&](const PortionSink& sink) { show(run, sink); });
    }
    void show(std::size_t run, const PortionSink& sink) {
        group_.synchronised(run, seen_);
        sink({0, seen_.velocity.count(), seen_});
    }

    std::ptrdiff_t runs() const { return static_cast<std::ptrdiff_t>(group_.runs()); }

    std::vector<std::unique_ptr<Member>>& members_;
    EnsembleStepper& group_;
    std::uint64_t every_;
    std::uint64_t step_ = 0;
    State<double> seen_;  ///< of one run
};

bool same_engine(const RunDescription& a, const RunDescription& b) {
    return a.model == b.model && a.origin == b.origin && a.method == b.method && a.precision == b.precision;
}

/// A run that counts the work of drag does so alone.
bool counts_drag(const EnsembleRun& run) { return run.with_errors && integrates_drag_work(run.description); }

/// The first of these runs that take one way through the code, and what their method needs of them.
struct Together {
    std::vector<std::unique_ptr<Member>> members;
    std::vector<StepperSetup> setups;

    Together(std::span<const EnsembleRun> runs, const Execution& execution) {
        for (const EnsembleRun& run : runs.first(std::min(runs.size(), most_lanes))) {
            if (!same_engine(run.description, runs.front().description) || counts_drag(run)) return;
            auto member = std::make_unique<Member>(run, execution);
            const StepperSetup setup = member->setup(execution);
            if (setups.empty() ? !fits_lanes(setup) : !lane_compatible(setups.front(), setup)) return;
            members.push_back(std::move(member));
            setups.push_back(setup);
        }
    }
};

}  // namespace

std::vector<std::optional<EnsembleResult>> run_in_lanes(std::span<const EnsembleRun> runs, std::uint64_t every,
                                                        const Execution& execution, const StepsDone& done) {
    const FlushSubnormals flush;
    const Method& how = method(runs.front().description.method);
    if (!how.runs_in_lanes(instructions_of(execution))) return {};
    Together together(runs, execution);
    if (together.setups.empty()) return {};
    const auto group = how.make_ensemble_stepper(together.setups);
    if (!group) return {};
    std::vector<std::unique_ptr<Member>>& members = together.members;
    LaneRuns(members, *group, every).run(done);
    std::vector<std::optional<EnsembleResult>> results(group->runs());
    for (std::size_t run = 0; run < results.size(); ++run) {
        if (!members[run]->diverged)
            results[run] = EnsembleResult{.result = std::move(members[run]->result), .in_lanes = true};
    }
    return results;
}

}  // namespace steplab
