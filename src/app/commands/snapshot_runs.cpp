#include "app/commands/snapshot_runs.hpp"

#include "app/cli/progress.hpp"
#include "core/error.hpp"
#include "core/interruption.hpp"
#include "lab/study/reference_motion.hpp"
#include "session/compared.hpp"
#include "session/run_view.hpp"
#include "sim/run/confirmed_steps.hpp"

#include <fmt/format.h>

#include <optional>
#include <string>
#include <unistd.h>

namespace steplab {
namespace {

Simulation run_at(double time, const RunDescription& description) {
    Simulation run(description);
    const std::uint64_t steps = step_at(time, run.dt());
    Progress progress(steps, isatty(STDERR_FILENO) != 0);
    ConfirmedSteps stepping(steps, [&progress](std::uint64_t step) {
        check_interruption();
        progress.at(step);
    });
    stepping.advance(run, steps);
    return run;
}

std::optional<Compared> compared_with(ReferenceMotion& motion, const Simulation& run) {
    if (run.divergence()) return std::nullopt;
    const Vec3 start = Simulation(run.description()).diagnostics().momentum;
    const ReferenceMoment there = motion.at(run.time());
    return compared(moment_of(run, start), there, motion.is_exact());
}

}  // namespace

std::vector<Simulation> runs_at(double time, std::span<const RunDescription> runs) {
    std::vector<Simulation> all;
    for (const RunDescription& run : runs) all.push_back(run_at(time, run));
    return all;
}

SessionErrors errors_of(const Simulation& leading, std::span<const Simulation> others) {
    ReferenceMotion motion(leading.description());
    SessionErrors errors{.time = leading.time(), .runs = {compared_with(motion, leading)}, .how = motion.how()};
    errors.exact = motion.is_exact();
    for (const Simulation& other : others) {
        ReferenceMotion own(other.description());  // its parameters may differ
        errors.runs.push_back(compared_with(own, other));
    }
    return errors;
}

void check_ends(const RunView& leading, const std::vector<RunView>& followers) {
    if (followers.empty() && leading.divergence) throw Error(ExitCode::diverged, leading.divergence->message);
    std::string messages;
    for (std::size_t i = 0; i <= followers.size(); ++i) {
        const auto& divergence = (i == 0 ? leading : followers[i - 1]).divergence;
        if (divergence) messages += fmt::format("{}run {}: {}", messages.empty() ? "" : "; ", i, divergence->message);
    }
    if (!messages.empty()) throw Error(ExitCode::diverged, messages);
}

}  // namespace steplab
