#include "app/commands/compare.hpp"

#include "app/cli/command_line.hpp"
#include "app/cli/compared_runs.hpp"
#include "app/cli/progress.hpp"
#include "app/cli/scene_options.hpp"
#include "app/cli/standard_streams.hpp"
#include "app/cli/text_table.hpp"
#include "core/error.hpp"
#include "core/interruption.hpp"
#include "core/larger_magnitude.hpp"
#include "core/number_text.hpp"
#include "io/compression.hpp"
#include "io/output_file.hpp"
#include "session/comparison.hpp"
#include "sim/run/notes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <unistd.h>

namespace steplab {

namespace {

constexpr const char* compare_examples =
    "Examples:\n"
    "  steplab compare --model rope --until 10 --run method=euler-forward,dt=0.01 --run method=rk4,dt=0.01\n"
    "  steplab compare --scene kepler-ellipse --run method=verlet,dt=0.01 --run "
    "method=verlet,dt=0.01,precision=float\n\n";

constexpr ParameterInfo samples_info{.name = "--samples",
                                     .kind = ParameterInfo::Kind::integer,
                                     .unit = "",
                                     .minimum = 1,
                                     .maximum = 1e9,
                                     .what = "number of equal parts of the time"};

std::string cell(const std::optional<double>& number) {
    return number && std::isfinite(*number) ? number_text(*number) : "";
}

/// The largest of what a run showed at any sample that it reached.
struct Worst {
    double error = 0, energy_error = 0;
    double until = 0;  ///< the last of these samples
    std::optional<Compared> last;

    void add(double time, const std::optional<Compared>& compared) {
        if (!compared) return;
        last = compared;
        until = time;
        error = std::max(error, compared->error);
        energy_error = larger_magnitude(energy_error, compared->energy_error.value_or(0));
    }
};

class CompareCommand final : public Command {
public:
    std::string_view name() const override { return "compare"; }
    std::string_view what() const override { return "Compare runs of one scene with its exact motion over time"; }

    void declare(CLI::App& app) override {
        scene_.declare(app);
        time_.declare(app);
        runs_.declare(app);
        text_option(app, "--samples", samples_, "N", "Number of equal parts of the time (default 100)", "Output");
        text_option(app, "--out", out_, "FILE|-", "CSV file (default -, standard output)", "Output");
        footer(app, [] { return std::string(compare_examples); });
    }

    int run() override {
        const RunDescription base = scene_.description();
        const std::vector<RunDescription> runs = runs_.runs(base);
        const double duration = time_.duration(base);
        const auto samples = static_cast<std::uint64_t>(parse_value(samples_info, samples_));
        catch_interruptions();
        OutputFile file(out_, compression_of(out_));
        RunComparison comparison(runs, duration, samples);
        for (std::size_t i = 0; i < runs.size(); ++i)
            print_aside(fmt::format("run {}: {}\n", i, variant_text(runs[i], base)));
        const std::vector<Worst> worst = write(comparison, samples, file);
        file.commit();
        print_summary(comparison, worst);
        for (std::size_t i = 0; i < runs.size(); ++i) {
            for (const std::string& note : notes_of_rounding(comparison.run(i)))
                print_note("steplab compare", fmt::format("run {}: {}", i, note));
        }
        return check_ends(comparison);
    }

private:
    /// All rows, as they are computed: for each sample those of all runs that got so far.
    std::vector<Worst> write(RunComparison& comparison, std::uint64_t samples, OutputFile& file) const {
        std::vector<Worst> worst(comparison.runs());
        const bool rows_on_terminal = out_ == "-" && isatty(STDOUT_FILENO) != 0;
        Progress progress(samples, isatty(STDERR_FILENO) != 0 && !rows_on_terminal, "steplab compare");
        file.write("time,run,error,rms_error,energy_error,momentum_error,reference_error,evaluations\n");
        for (std::uint64_t sample = 0; sample <= samples; ++sample) {
            const double time = comparison.time(sample);
            const auto all = comparison.at(sample);
            for (std::size_t i = 0; i < all.size(); ++i) {
                worst[i].add(time, all[i]);
                if (all[i]) file.write(row(time, i, *all[i]));
            }
            progress.at(sample);
        }
        return worst;
    }

    static std::string row(double time, std::size_t run, const Compared& compared) {
        return fmt::format("{},{},{},{},{},{},{},{}\n", number_text(time), run, cell(compared.error),
                           cell(compared.rms_error), cell(compared.energy_error), cell(compared.momentum_error),
                           cell(compared.reference_error), compared.evaluations);
    }

    /// A run that diverged has none but of the samples before, which say little: at the start all errors are 0.
    static std::string largest_error(const Worst& worst, const Simulation& run) {
        std::string error = worst.last ? typed(worst.error, 3) : "";
        const auto& divergence = run.divergence();
        if (!divergence) return error;
        const std::string where = fmt::format("diverged at t = {} s", typed(divergence->time, 4));
        return worst.until > 0 ? fmt::format("{} ({} before)", where, error) : where;
    }

    static std::string largest_energy_error(const Worst& worst, const Simulation& run) {
        const bool known = worst.last && worst.last->energy_error && (!run.divergence() || worst.until > 0);
        return known ? typed(worst.energy_error, 3) : "";
    }

    /// For people: on standard error where the rows are on standard output.
    void print_summary(const RunComparison& comparison, const std::vector<Worst>& worst) const {
        std::vector<Row> rows{{"RUN", "LARGEST ERROR [m]", "ENERGY ERROR [J]", "EVALUATIONS", "REFERENCE"}};
        for (std::size_t i = 0; i < worst.size(); ++i) {
            const Simulation& run = comparison.run(i);
            rows.push_back({std::to_string(i), largest_error(worst[i], run), largest_energy_error(worst[i], run),
                            worst[i].last ? std::to_string(run.evaluations()) : "", comparison.reference(i)});
        }
        print_beside(aligned(rows, 2), out_ == "-");
    }

    static int check_ends(const RunComparison& comparison) {
        std::string messages;
        for (std::size_t i = 0; i < comparison.runs(); ++i) {
            const auto& divergence = comparison.run(i).divergence();
            if (divergence)
                messages += fmt::format("{}run {}: {}", messages.empty() ? "" : "; ", i, divergence->message);
        }
        if (messages.empty()) return static_cast<int>(ExitCode::done);
        throw Error(ExitCode::diverged, messages);
    }

    SceneOptions scene_;
    TimeOptions time_{1000, TimeOptions::Default::scene};
    ComparedRuns runs_;
    std::string samples_ = "100";
    std::string out_ = "-";
};

}  // namespace

std::unique_ptr<Command> compare_command() { return std::make_unique<CompareCommand>(); }

}  // namespace steplab
