#pragma once

#include "lab/study/reference_motion.hpp"
#include "session/compared.hpp"
#include "sim/run/confirmed_steps.hpp"
#include "sim/run/simulation.hpp"

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace steplab {

/// Runs of a scene taken to the same times and compared with its motion there: each with that of its own parameters,
/// which the runs that have the same ones share.
class RunComparison {
public:
    static constexpr std::size_t most_runs = 4;

    /// Of a duration > 0, over which so many samples are taken, equally far apart. Throws UsageError.
    RunComparison(const std::vector<RunDescription>& runs, double duration, std::uint64_t samples);

    std::size_t runs() const { return runs_.size(); }
    const Simulation& run(std::size_t i) const { return runs_[i].simulation; }
    /// The reference of a run, in words.
    std::string reference(std::size_t i) const { return references_[runs_[i].reference].motion.how(); }

    double time(std::uint64_t sample) const;
    /// Takes every run to its step at the time of the sample (step_at()), whose number is not less than that before,
    /// and compares it there. None of a run that did not get so far. Throws Interrupted.
    std::vector<std::optional<Compared>> at(std::uint64_t sample);

private:
    struct Run {
        Simulation simulation;
        ConfirmedSteps steps;
        Vec3 start_momentum;
        std::size_t reference;
        std::optional<Compared> last;
    };
    struct Reference {
        RunDescription of;
        ReferenceMotion motion;
    };

    RunDescription sampled(RunDescription description) const;
    std::size_t reference_of(const RunDescription& description);

    double duration_;
    std::uint64_t samples_;
    std::vector<Reference> references_;
    std::vector<Run> runs_;
};

}  // namespace steplab
