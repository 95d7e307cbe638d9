#include "app/commands/cluster.hpp"

#include "app/cli/catalogue_text.hpp"
#include "app/cli/command_line.hpp"
#include "app/cli/lammps_options.hpp"
#include "app/cli/progress.hpp"
#include "app/cli/scene_options.hpp"
#include "app/cli/standard_streams.hpp"
#include "app/commands/cluster_results.hpp"
#include "core/error.hpp"
#include "core/interruption.hpp"
#include "core/shell_word.hpp"
#include "core/shown.hpp"
#include "core/text.hpp"
#include "io/lammps/lammps_run.hpp"
#include "io/lammps/lammps_submit.hpp"
#include "io/output_file.hpp"
#include "io/temporary_folder.hpp"
#include "io/trajectory_format.hpp"

#include <fmt/format.h>

#include <array>
#include <chrono>
#include <optional>
#include <unistd.h>

namespace steplab {

namespace {

constexpr const char* cluster_examples =
    "Examples:\n"
    "  steplab cluster --model mesh --set dim=1000 --steps 200 --ranks 2 --every 50 --out mesh.trajectory\n"
    "  steplab cluster --scene fcc-crystal --until 20 --ranks 256 --submit slurm --files job\n"
    "  steplab cluster --scene fcc-crystal --until 20 --collect job --out crystal.trajectory\n\n";

constexpr unsigned microseconds_of_waiting = 50'000;
constexpr std::array<std::string_view, 1> batch_systems{"slurm"};

class ClusterCommand final : public Command {
public:
    std::string_view name() const override { return "cluster"; }
    std::string_view what() const override { return "Run a simulation by LAMMPS, on several MPI ranks"; }

    void declare(CLI::App& app) override {
        const std::string group = "LAMMPS";
        scene_.declare(app);
        time_.declare(app);
        lammps_.declare(app);
        text_option(app, "--ranks", ranks_, "N", "Number of MPI ranks (required, but with --collect)", group);
        text_option(app, "--files", files_, "DIR", "Folder that keeps the files of LAMMPS (default: none)", group);
        text_option(app, "--submit", submit_, "slurm", "Write a batch file into --files instead of running", group);
        text_option(app, "--collect", collect_, "DIR",
                    "Give the results of a batch job that has ended, of the same SCENE, TIME and --every", group);
        text_option(app, "--out", out_, "FILE|-", "Positions and velocities; - for standard output", "Output");
        text_option(app, "--summary", summary_, "FILE|-", "Summary of the run (JSON)", "Output");
        footer(app, [] { return std::string(cluster_examples) + catalogue_hint(); });
    }

    int run() override {
        check_options();
        const RunDescription run = with_method(lammps_method_checked(scene_), "velocity-verlet");
        const LammpsTime time = lammps_.time(time_.end(run).step);
        if (!out_.empty()) trajectory_format_of(out_);  // throws before anything is computed
        if (!out_.empty() && out_ == summary_) throw UsageError("--out and --summary both write to one place");
        catch_interruptions();
        if (!collect_.empty()) return collect(run, time);
        const std::uint64_t ranks = ranks_of(ranks_);
        if (!submit_.empty()) return submit(run, time, ranks);
        check_ranks(ranks, model_of(run).particles(run.scene));
        check_lammps_installed(ranks);
        return compute(run, time, ranks);
    }

private:
    void check_options() const {
        if (!collect_.empty() && !(ranks_.empty() && files_.empty() && submit_.empty()))
            throw UsageError(
                "--collect takes the files of a job that has ended: --ranks, --files and --submit began it");
        if (collect_.empty() && ranks_.empty())
            throw UsageError("--ranks is required: the number of MPI ranks, such as --ranks 2");
        if (!submit_.empty() && !(out_.empty() && summary_.empty()))
            throw UsageError(
                "--submit computes nothing yet: --out and --summary are for `steplab cluster SCENE TIME --collect DIR` "
                "once the job has ended");
    }

    static void check_ranks(std::uint64_t ranks, double particles) {
        if (static_cast<double>(ranks) > particles)
            throw UsageError(
                fmt::format("--ranks {}: the scene has {:.0f} particles; a rank takes one at least", ranks, particles));
    }

    int submit(const RunDescription& run, const LammpsTime& time, std::uint64_t ranks) const {
        if (submit_ != batch_systems[0]) throw UsageError(unknown_word("batch system", submit_, batch_systems));
        if (files_.empty()) throw UsageError("--submit needs --files DIR, a folder that the cluster can read");
        check_slurm_folder(files_);
        refuse_results(files_);
        const LammpsExport written = export_to_lammps(run, time, files_);
        const std::string batch = write_slurm_file(files_, model_of(run).info.name, ranks);
        print(export_text(written, files_) + fmt::format("  {:<14}sbatch {}\n", "submit", shell_file(batch)) +
              fmt::format("  {:<14}the same SCENE, TIME and --every with --collect {} --out FILE --summary FILE\n",
                          "afterwards", shell_file(files_)));
        return static_cast<int>(ExitCode::done);
    }

    int compute(const RunDescription& run, const LammpsTime& time, std::uint64_t ranks) const {
        // results are written from a folder that goes, unless one was asked for
        std::optional<TemporaryFolder> temporary;
        if (files_.empty()) temporary.emplace("lammps-");
        const std::string& folder = temporary ? temporary->path() : files_;
        try {
            remove_results(folder);
            const LammpsExport written = export_to_lammps(run, time, folder);
            LammpsRun lammps(folder, ranks);
            const auto begin = std::chrono::steady_clock::now();
            wait_for(lammps, time.steps);
            const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
            give_results(run, time, written, lammps.output(), seconds);
        } catch (const UsageError&) {
            throw;
        } catch (...) {
            if (temporary) temporary->keep();
            print_aside(fmt::format("steplab cluster: the files of LAMMPS are kept in '{}'\n", shown(folder)));
            throw;
        }
        return static_cast<int>(ExitCode::done);
    }

    /// Of a batch job, which was written from the same scene.
    int collect(const RunDescription& run, const LammpsTime& time) const {
        const LammpsExport written = check_is_export(run, time, collect_);
        give_results(run, time, written, LammpsOutput(collect_), std::nullopt);
        return static_cast<int>(ExitCode::done);
    }

    /// Whatever it said at its end, it has to have gone all steps. `seconds`: none: as LAMMPS says.
    void give_results(const RunDescription& run, const LammpsTime& time, const LammpsExport& written,
                      const LammpsOutput& output, std::optional<double> seconds) const {
        const std::vector<LammpsEnergy> energies = output.energies();
        const std::optional<LammpsLoop> loop = output.loop();
        if (!loop || energies.back().step != time.steps)
            throw Error(ExitCode::diverged, fmt::format("LAMMPS has not gone all steps (step {} of {}): {}",
                                                        energies.back().step, time.steps, output.message()));
        RunSummary summary =
            cluster_summary(run, time.steps, written.particles, energies, seconds.value_or(loop->seconds));
        summary.notes = written.notes;
        summary.notes.push_back(
            fmt::format("computed by {} on {} MPI rank{}", output.version(), loop->ranks, loop->ranks == 1 ? "" : "s"));
        if (!out_.empty()) write_cluster_rows(run, time, output.folder(), summary.result, out_);
        report(summary);
        if (const auto& diverged = summary.result.divergence) throw Error(ExitCode::diverged, diverged->message);
    }

    static void wait_for(LammpsRun& lammps, std::uint64_t steps) {
        Progress progress(std::max<std::uint64_t>(1, steps), isatty(STDERR_FILENO) != 0, "steplab cluster");
        while (lammps.is_running()) {
            check_interruption();
            if (const auto step = lammps.output().step()) progress.at(*step);
            usleep(microseconds_of_waiting);
        }
        lammps.finish();
    }

    void report(const RunSummary& summary) const {
        if (!summary_.empty()) {
            OutputFile file(summary_);
            file.write(summary_json(summary));
            file.commit();
        }
        std::string text = summary_text(summary);
        for (const std::string& note : summary.notes) text += fmt::format("  {:<14}{}\n", "note", note);
        for (const std::string& file : {out_, summary_, files_}) {
            if (!file.empty() && file != "-") text += fmt::format("  {:<14}{}\n", "written", shown(file));
        }
        print_beside(text, out_ == "-" || summary_ == "-");
    }

    SceneOptions scene_{SceneOptions::Methods::lammps};
    TimeOptions time_{1000, TimeOptions::Default::scene};
    LammpsOptions lammps_;
    std::string ranks_, files_, submit_, collect_, out_, summary_;
};

}  // namespace

std::unique_ptr<Command> cluster_command() { return std::make_unique<ClusterCommand>(); }

}  // namespace steplab
