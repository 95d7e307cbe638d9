#include "app/command_run.hpp"

#include "app/catalogue_text.hpp"
#include "app/command_line.hpp"
#include "app/pacer.hpp"
#include "app/progress.hpp"
#include "app/run_outputs.hpp"
#include "app/scene_options.hpp"
#include "core/error.hpp"
#include "io/interruption.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <unistd.h>

namespace steplab {

namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point begin) { return std::chrono::duration<double>(Clock::now() - begin).count(); }

constexpr const char* examples =
    "Examples:\n"
    "  steplab run --model chain --set n=20 --until 100 --every 10 --out chain.csv\n"
    "  steplab run --model rope --method rk4 --dt 0.02 --series energy.csv --summary -\n\n";

class RunCommand final : public Command {
public:
    std::string_view name() const override { return "run"; }
    std::string_view what() const override { return "Compute a run and write its numbers"; }

    void declare(CLI::App& app) override {
        scene_.declare(app);
        time_.declare(app);
        text_option(app, "--every", every_, "K", "Write every K steps (default: first and last only)")->group("Output");
        output_.declare(app);
        text_option(app, "--isa", isa_, "SET", "Instruction set of the processor (default: the fastest)")
            ->group("Computing");
        text_option(app, "--threads", threads_, "N", "At most so many, where they pay (default: all processors)")
            ->group("Computing");
        app.footer([] { return std::string(examples) + catalogue_help(); });
    }

    int run() override {
        const RunDescription description = scene_.description();
        steps_ = time_.steps(description);
        const std::uint64_t every = every_.empty()
                                        ? std::max<std::uint64_t>(1, steps_)
                                        : whole_number("--every", every_, 9007199254740992.0, "steps between two rows");
        output_.check();
        catch_interruptions();
        RunOutputs outputs(output_, description);
        Simulation simulation(description, execution());
        try {
            const RunSummary summary = compute(simulation, every, outputs);
            outputs.commit(summary);
            show(summary);
        } catch (const Interrupted&) {
            tell_interruption(simulation.step(), outputs.keep_partial());
            throw;
        }
        if (!simulation.divergence()) return static_cast<int>(ExitCode::done);
        throw Error(ExitCode::diverged, simulation.divergence()->message);
    }

private:
    Execution execution() const {
        Execution execution;
        if (!isa_.empty()) execution.instructions = parse_instructions(isa_);
        if (!threads_.empty())
            execution.threads = whole_number("--threads", threads_, 1024, "threads that step a run, at most");
        return execution;
    }

    static std::uint64_t whole_number(std::string_view option, const std::string& text, double maximum,
                                      std::string_view what) {
        const ParameterInfo info{.name = option,
                                 .kind = ParameterInfo::Kind::integer,
                                 .unit = "",
                                 .minimum = 1,
                                 .maximum = maximum,
                                 .what = what};
        return static_cast<std::uint64_t>(parse_value(info, text));
    }

    /// Takes the steps and records the first one, every K-th and the last one.
    RunSummary compute(Simulation& simulation, std::uint64_t every, RunOutputs& outputs) {
        const bool rows_on_terminal = output_.standard_output_taken() && isatty(STDOUT_FILENO) != 0;
        Progress progress(steps_, isatty(STDERR_FILENO) != 0 && !rows_on_terminal);
        Pacer pacer(steps_);
        const auto begin = Clock::now();
        RunSummary summary;
        summary.energy_start = simulation.energy();
        outputs.record(simulation);
        for (std::uint64_t recorded = 0; recorded < steps_ && !simulation.divergence();) {
            pacer.advance(simulation, std::min(steps_, recorded + every), progress);
            if (simulation.step() == recorded) break;  // no step more was good
            recorded = simulation.step();
            summary.energy_error = std::max(summary.energy_error, std::abs(simulation.energy_error()));
            outputs.record(simulation);
        }
        summary.energy_end = simulation.energy();
        summary.wall_seconds = seconds_since(begin);
        describe(simulation, summary);
        return summary;
    }

    static void describe(const Simulation& simulation, RunSummary& summary) {
        const RunDescription& description = simulation.description();
        summary.model = description.model;
        summary.method = description.method;
        summary.precision = description.precision;
        summary.dt = simulation.dt();
        summary.steps = simulation.step();
        summary.time = simulation.time();
        summary.particles = simulation.particles();
        summary.evaluations = simulation.evaluations();
        summary.hash = simulation.hash();
        summary.collisions = simulation.collisions();
        summary.drag = has_drag(description);
        if (simulation.divergence()) summary.diverged_step = simulation.step() + 1;
    }

    void show(const RunSummary& summary) const {
        std::string text = summary_text(summary);
        if (const std::string files = output_.files(); !files.empty())
            text += fmt::format("  {:<14}{}\n", "written", files);
        if (output_.standard_output_taken()) {
            std::fputs(text.c_str(), stderr);
        } else {
            print(text);
        }
    }

    static void tell_interruption(std::uint64_t step, const std::vector<std::string>& kept) {
        std::string text = fmt::format("steplab run: interrupted after step {}", step);
        if (!kept.empty()) text += fmt::format("; what was written is kept as '{}'", fmt::join(kept, "' and '"));
        std::fputs((text + '\n').c_str(), stderr);
    }

    SceneOptions scene_;
    TimeOptions time_{1000};
    std::string every_;
    std::string isa_, threads_;
    OutputOptions output_;
    std::uint64_t steps_ = 0;
};

}  // namespace

std::unique_ptr<Command> run_command() { return std::make_unique<RunCommand>(); }

}  // namespace steplab
