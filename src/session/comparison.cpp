#include "session/comparison.hpp"

#include <algorithm>
#include <utility>

namespace steplab {

RunComparison::RunComparison(const std::vector<RunDescription>& runs, double duration, std::uint64_t samples)
    : duration_(duration), samples_(samples) {
    for (const RunDescription& description : runs) {
        Simulation simulation(sampled(description));
        simulation.count_drag_work();
        const Vec3 momentum = simulation.diagnostics().momentum;
        const ConfirmedSteps steps(step_at(duration, simulation.dt()));
        runs_.push_back({std::move(simulation), steps, momentum, reference_of(description), std::nullopt});
    }
}

/// The steps of some methods depend on their tolerance alone: dt is the distance of the times at which they are
/// evaluated.
RunDescription RunComparison::sampled(RunDescription description) const {
    if (chooses_its_steps(description)) description.dt = duration_ / static_cast<double>(samples_);
    return description;
}

/// It ignores the precision of the run: that of float is one of the errors to be seen.
std::size_t RunComparison::reference_of(const RunDescription& description) {
    const auto same = [&](const Reference& known) { return known.of.scene == description.scene; };
    const auto found = std::find_if(references_.begin(), references_.end(), same);
    if (found != references_.end()) return static_cast<std::size_t>(found - references_.begin());
    references_.push_back({description, ReferenceMotion(description)});
    return references_.size() - 1;
}

double RunComparison::time(std::uint64_t sample) const {
    return duration_ * static_cast<double>(sample) / static_cast<double>(samples_);
}

std::vector<std::optional<Compared>> RunComparison::at(std::uint64_t sample) {
    std::vector<Run*> moved;
    for (Run& run : runs_) {
        const std::uint64_t step = step_at(time(sample), run.simulation.dt());
        run.steps.advance(run.simulation, step);
        if (run.simulation.step() < step) {
            run.last.reset();
        } else if (!run.last || run.last->step != step) {
            moved.push_back(&run);
        }
    }
    // the references go forward only
    std::sort(moved.begin(), moved.end(),
              [](const Run* a, const Run* b) { return a->simulation.time() < b->simulation.time(); });
    for (Run* run : moved) {
        ReferenceMotion& reference = references_[run->reference].motion;
        const ReferenceMoment there = reference.at(run->simulation.time());
        run->last = compared(moment_of(run->simulation, run->start_momentum), there, reference.is_exact());
    }
    std::vector<std::optional<Compared>> all;
    for (const Run& run : runs_) all.push_back(run.last);
    return all;
}

}  // namespace steplab
