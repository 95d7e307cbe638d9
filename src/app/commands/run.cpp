#include "app/commands/run.hpp"

#include "app/cli/catalogue_text.hpp"
#include "app/cli/command_line.hpp"
#include "app/cli/ensemble_options.hpp"
#include "app/cli/progress.hpp"
#include "app/cli/scene_options.hpp"
#include "app/cli/standard_streams.hpp"
#include "app/commands/ensemble_job.hpp"
#include "app/commands/run_outputs.hpp"
#include "core/error.hpp"
#include "core/interruption.hpp"
#include "core/number_text.hpp"
#include "io/recorded_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <unistd.h>

namespace steplab {

namespace {

constexpr const char* run_examples =
    "Examples:\n"
    "  steplab run --model chain --set n=20 --until 100 --every 10 --out chain.csv\n"
    "  steplab run --model rope --method rk4 --dt 0.02 --series energy.csv --summary -\n"
    "  steplab run --model chain --ensemble 100 --spread k=1:2 --until 50 --summary -\n\n";

constexpr const char* program = "steplab run";

class RunCommand final : public Command {
public:
    std::string_view name() const override { return "run"; }
    std::string_view what() const override { return "Run a simulation and write the results"; }

    void declare(CLI::App& app) override {
        scene_.declare(app);
        time_.declare(app);
        text_option(app, "--every", every_, "K", "Write every K-th step (default: first and last step only)", "Output");
        output_.declare(app);
        ensemble_.declare(app);
        text_option(app, "--isa", isa_, "SET", "Instruction set (default: the fastest available)", "Computation");
        text_option(app, "--threads", threads_, "N", "Maximum number of threads (default: all cores)", "Computation");
        footer(app, [] { return std::string(run_examples) + catalogue_hint(); });
    }

    int run() override {
        const RunDescription description = scene_.description();
        output_.check();
        if (ensemble_.is_given()) return run_ensemble(description);
        const RunEnd end = time_.end(description);
        const std::uint64_t steps = end.step, rows_every = every(steps);
        catch_interruptions();
        RunOutputs outputs(output_, description);
        Simulation simulation(description, execution());
        if (output_.asks_for_energy_error()) simulation.count_drag_work();
        try {
            const bool rows_on_terminal = output_.standard_output_taken() && isatty(STDOUT_FILENO) != 0;
            Progress progress(steps, isatty(STDERR_FILENO) != 0 && !rows_on_terminal);
            RunSummary summary = record_run(
                simulation, end, rows_every, [&progress](std::uint64_t step) { progress.at(step); },
                [&outputs](const Simulation& now) { outputs.record(now); });
            const auto note_of_end = time_.note(description, end);
            if (note_of_end && !summary.result.divergence) summary.notes.push_back(*note_of_end);
            outputs.commit(summary);
            output_.print_summary(summary_text(summary));
            for (const std::string& note : summary.notes) print_note(program, note);
        } catch (const Interrupted&) {
            print_interruption(fmt::format("interrupted after step {}", simulation.step()), outputs.keep_partial());
            throw;
        }
        if (!simulation.divergence()) return static_cast<int>(ExitCode::done);
        throw Error(ExitCode::diverged, simulation.divergence()->message);
    }

private:
    int run_ensemble(const RunDescription& description) const {
        if (!output_.observables.empty()) throw UsageError("--observables are those of one run, not of an ensemble");
        const std::vector<ParameterRange> ranges = ensemble_.ranges(description);
        EnsembleJob job{.ranges = ranges,
                        .runs = ensemble_.runs(description, ranges, time_),
                        .output = output_,
                        .execution = execution()};
        const auto fewer_steps = [](const EnsembleRun& a, const EnsembleRun& b) { return a.end.step < b.end.step; };
        const auto longest = std::max_element(job.runs.begin(), job.runs.end(), fewer_steps);
        job.every = every(longest->end.step);
        if (const auto note = time_.note(longest->description, longest->end))
            job.note_of_end = "the longest run: " + *note;
        for (EnsembleRun& run : job.runs) run.with_errors = output_.asks_for_energy_error();
        catch_interruptions();
        job.run();
        return static_cast<int>(ExitCode::done);
    }

    /// Steps between two rows of a run of `steps` steps.
    std::uint64_t every(std::uint64_t steps) const {
        if (every_.empty()) return std::max<std::uint64_t>(1, steps);
        return whole_number("--every", every_, 9007199254740992.0, "steps between two rows");
    }

    Execution execution() const {
        Execution execution;
        if (!isa_.empty()) execution.instructions = parse_instructions(isa_);
        if (!threads_.empty())
            execution.threads = whole_number("--threads", threads_, 1024, "maximum number of threads");
        return execution;
    }

    SceneOptions scene_{SceneOptions::Time::both};
    TimeOptions time_{1000, TimeOptions::Default::scene};
    std::string every_;
    std::string isa_, threads_;
    OutputOptions output_;
    EnsembleOptions ensemble_;
};

}  // namespace

std::unique_ptr<Command> run_command() { return std::make_unique<RunCommand>(); }

}  // namespace steplab
