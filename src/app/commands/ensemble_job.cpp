#include "app/commands/ensemble_job.hpp"

#include "app/cli/command_line.hpp"
#include "app/cli/progress.hpp"
#include "app/commands/ensemble_rows.hpp"
#include "core/error.hpp"
#include "core/interruption.hpp"
#include "io/recorded_run.hpp"
#include "io/summary.hpp"
#include "sim/run/notes.hpp"

#include <fmt/format.h>

#include <chrono>
#include <numeric>
#include <optional>
#include <string>
#include <unistd.h>

namespace steplab {

namespace {

using Clock = std::chrono::steady_clock;

/// The runs without rows: in SIMD lanes and in parallel.
std::vector<RunSummary> computed(const EnsembleJob& job) {
    const std::uint64_t steps =
        std::accumulate(job.runs.begin(), job.runs.end(), std::uint64_t(0),
                        [](std::uint64_t sum, const EnsembleRun& run) { return sum + run.end.step; });
    Progress progress(steps, isatty(STDERR_FILENO) != 0);
    const auto results = run_ensemble(job.runs, job.every, job.execution, [&](std::uint64_t done) {
        check_interruption();
        progress.at(done);
    });
    std::vector<RunSummary> summaries;
    for (std::size_t i = 0; i < results.size(); ++i)
        summaries.push_back(
            {.run = job.runs[i].description, .result = results[i].result, .until = job.runs[i].end.time});
    return summaries;
}

/// The runs with their rows, one after another.
std::vector<RunSummary> recorded(const EnsembleJob& job, EnsembleRows& rows) {
    std::vector<RunSummary> summaries;
    for (std::size_t i = 0; i < job.runs.size(); ++i) {
        const EnsembleRun& run = job.runs[i];
        rows.begin(i, run.description);
        Simulation simulation(run.description, job.execution);
        if (run.with_errors) simulation.count_drag_work();
        summaries.push_back(record_run(
            simulation, run.end, job.every, [](std::uint64_t) {},
            [&rows](const Simulation& now) { rows.record(now); }));
        check_interruption();
    }
    return summaries;
}

EnsembleSummary summary_of(const EnsembleJob& job, const std::vector<RunSummary>& runs, double seconds) {
    EnsembleSummary summary;
    NotesOfRuns notes;
    summary.wall_seconds = seconds;
    for (const ParameterRange& range : job.ranges) summary.ranges.push_back({range.name, range.from, range.to});
    for (std::size_t i = 0; i < runs.size(); ++i) {
        std::vector<double> values;
        for (const ParameterRange& range : job.ranges) values.push_back(range.value(i, runs.size()));
        summary.runs.push_back({values, runs[i]});
        if (runs[i].result.divergence) {
            notes.add_diverged();
        } else {
            notes.add(runs[i].run, runs[i].result.farthest);
        }
    }
    summary.notes = notes.all();
    if (job.note_of_end) summary.notes.push_back(*job.note_of_end);
    return summary;
}

std::string divergence_message(const EnsembleSummary& summary) {
    std::size_t first = 0;
    while (!summary.runs[first].summary.result.divergence) ++first;
    return fmt::format("{} of {} runs diverged, the first of them run {} in step {}", summary.diverged(),
                       summary.runs.size(), first, *summary.runs[first].summary.result.diverged_step());
}

}  // namespace

void EnsembleJob::run() const {
    EnsembleRows rows(output, runs);
    std::optional<OutputFile> summary_file;
    if (!output.summary.empty()) summary_file.emplace(output.summary, compression_of(output.summary));
    const auto begin = Clock::now();
    try {
        const auto done = rows.wanted() ? recorded(*this, rows) : computed(*this);
        const EnsembleSummary summary =
            summary_of(*this, done, std::chrono::duration<double>(Clock::now() - begin).count());
        rows.commit();
        if (summary_file) summary_file->write(summary_json(summary)), summary_file->commit();
        output.print_summary(summary_text(summary));
        for (const std::string& note : summary.notes) print_note("steplab run", note);
        if (summary.diverged() > 0) throw Error(ExitCode::diverged, divergence_message(summary));
    } catch (const Interrupted&) {
        print_interruption("interrupted", rows.keep_partial());
        throw;
    }
}

}  // namespace steplab
