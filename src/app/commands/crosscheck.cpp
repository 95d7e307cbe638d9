#include "app/commands/crosscheck.hpp"

#include "app/cli/catalogue_text.hpp"
#include "app/cli/command_line.hpp"
#include "app/cli/lammps_options.hpp"
#include "app/cli/progress.hpp"
#include "app/cli/scene_options.hpp"
#include "app/cli/standard_streams.hpp"
#include "app/cli/text_table.hpp"
#include "core/error.hpp"
#include "core/interruption.hpp"
#include "core/number_text.hpp"
#include "core/shown.hpp"
#include "io/temporary_folder.hpp"
#include "lab/crosscheck/crosscheck.hpp"

#include <fmt/format.h>

#include <unistd.h>

namespace steplab {

namespace {

constexpr const char* crosscheck_examples =
    "Examples:\n"
    "  steplab crosscheck --model mesh --steps 500\n"
    "  steplab crosscheck --scene fcc-crystal --until 1 --ranks 2\n\n";

std::string table(const Crosscheck& check) {
    std::vector<Row> rows;
    for (const CrosscheckMoment& moment : check.moments)
        rows.push_back({short_number(moment.time), rounded_text(moment.position), rounded_text(moment.allowed_position),
                        rounded_text(moment.velocity), rounded_text(moment.allowed_velocity),
                        rounded_text(moment.energy)});
    return aligned({"time [s]", "positions [m]", "allowed", "velocities [m/s]", "allowed", "energy [J]"}, rows, 2);
}

class CrosscheckCommand final : public Command {
public:
    std::string_view name() const override { return "crosscheck"; }
    std::string_view what() const override { return "Compute a scene with LAMMPS as well, and compare"; }

    void declare(CLI::App& app) override {
        scene_.declare(app);
        time_.declare(app);
        text_option(app, "--ranks", ranks_, "N", "MPI ranks of LAMMPS (default 1)", "LAMMPS");
        text_option(app, "--samples", samples_, "N", "Number of moments that are compared (default 20)", "LAMMPS");
        text_option(app, "--out", out_, "DIR", "Folder that keeps the files of LAMMPS (default: none)", "LAMMPS");
        footer(app, [] { return std::string(crosscheck_examples) + catalogue_hint(); });
    }

    int run() override {
        const RunDescription run = lammps_method_checked(scene_);
        CrosscheckOptions options{.steps = time_.end(run).step,
                                  .samples = samples_of(samples_),
                                  .ranks = ranks_of(ranks_),
                                  .folder = out_,
                                  .exported = {},
                                  .progress = {}};
        catch_interruptions();
        const TemporaryFolder temporary;
        if (out_.empty()) options.folder = temporary.path();
        Progress progress(1, isatty(STDERR_FILENO) != 0, "steplab crosscheck");
        options.progress = [&](double part) { progress.at_part(part); };
        const Crosscheck check = crosscheck(run, options);
        progress.clear();
        print(fmt::format("{}, {} steps of dt {}, velocity Verlet here and in {}\n\n{}\n{}\n", shown(run.model),
                          options.steps, exact_text(run.dt), check.lammps, table(check),
                          wrapped(check.verdict_text() + ".", 0)));
        return static_cast<int>(check.agrees() ? ExitCode::done : ExitCode::replay);
    }

private:
    SceneOptions scene_{SceneOptions::Methods::lammps};
    TimeOptions time_{1000, TimeOptions::Default::scene};
    std::string ranks_ = "1", samples_ = "20", out_;
};

}  // namespace

std::unique_ptr<Command> crosscheck_command() { return std::make_unique<CrosscheckCommand>(); }

}  // namespace steplab
