#include "app/commands/snapshot_runs.hpp"

#include "app/cli/progress.hpp"
#include "core/error.hpp"
#include "core/interruption.hpp"
#include "session/compared.hpp"
#include "sim/run/confirmed_steps.hpp"

#include <fmt/format.h>

#include <string>
#include <unistd.h>

namespace steplab {
namespace {

RunView view_at(double time, const RunDescription& description, std::optional<std::size_t> tracked) {
    Simulation run(description);
    const std::uint64_t steps = step_at(time, run.dt());
    Progress progress(steps, isatty(STDERR_FILENO) != 0);
    ConfirmedSteps stepping(steps, [&progress](std::uint64_t step) {
        check_interruption();
        progress.at(step);
    });
    stepping.advance(run, steps);
    return view_of(run, tracked);
}

}  // namespace

std::vector<RunView> views_at(double time, std::span<const RunDescription> runs, std::optional<std::size_t> tracked) {
    std::vector<RunView> views;
    for (const RunDescription& run : runs) views.push_back(view_at(time, run, tracked));
    return views;
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
