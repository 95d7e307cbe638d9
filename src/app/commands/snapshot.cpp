#include "app/commands/snapshot.hpp"

#include "app/cli/command_line.hpp"
#include "app/cli/ensemble_options.hpp"
#include "app/cli/progress.hpp"
#include "app/cli/scene_options.hpp"
#include "app/cli/shown_runs_options.hpp"
#include "app/commands/snapshot_ensemble.hpp"
#include "app/commands/snapshot_options.hpp"
#include "app/commands/snapshot_runs.hpp"
#include "app/png.hpp"
#include "core/interruption.hpp"
#include "core/number_text.hpp"
#include "io/output_file.hpp"
#include "sim/run/confirmed_steps.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <span>
#include <unistd.h>
#include <vector>

namespace steplab {

namespace {

// Samples of the run for the panel's plots; fewer of large scenes, where each takes long.
constexpr std::uint64_t most_samples = 400;
constexpr std::uint64_t most_particle_samples = 20'000'000;

class SnapshotCommand final : public Command {
public:
    std::string_view name() const override { return "snapshot"; }
    std::string_view what() const override { return "Draw a run at one time as a PNG file, without a display"; }

    void declare(CLI::App& app) override {
        scene_.declare(app);
        time_.declare(app);
        picture_.declare(app);
        runs_.declare(app);
        ensemble_.declare(app);
    }

    int run() override {
        const std::vector<RunDescription> runs = runs_.runs(scene_.description());
        const RunDescription& description = runs.front();
        const RunEnd end = time_.end(description);
        PictureRequest request = picture_.request(description);
        runs_.put_into(request.style);
        catch_interruptions();
        std::optional<SnapshotEnsemble> ensemble = ensemble_of(description);
        OutputFile file(picture_.out());
        Offscreen offscreen(picture_.gl());
        Simulation simulation(description);
        simulation.end_at(end);
        compute(simulation, end.step, request);
        if (ensemble) ensemble->put_into(request.view);
        put_beside(simulation, std::span(runs).subspan(1), request);
        const Picture picture = offscreen.draw(request);
        file.write(encode_png(picture.size.width, picture.size.height, picture.rgba));
        file.commit();
        if (const auto note = time_.note(description, end)) fmt::print(stderr, "steplab snapshot: note: {}\n", *note);
        if (!written_directly(picture_.out())) print_result(request.view, offscreen.kind());
        check_ends(request.view, request.followers);
        return static_cast<int>(ExitCode::done);
    }

private:
    /// Takes the steps; samples them for the panel's plots.
    void compute(Simulation& simulation, std::uint64_t steps, PictureRequest& request) const {
        Progress progress(steps, isatty(STDERR_FILENO) != 0);
        ConfirmedSteps stepping(steps, [&progress](std::uint64_t step) {
            check_interruption();
            progress.at(step);
        });
        const std::optional<std::size_t> particle = followed_particle(simulation, request);
        const std::uint64_t bound = std::max<std::uint64_t>(16, most_particle_samples / simulation.particles());
        const std::uint64_t samples = request.panel ? std::min({steps, most_samples, bound}) : 1;
        for (std::uint64_t sample = 0; sample < samples && !simulation.divergence(); ++sample) {
            if (request.panel) request.past.push_back(without_particles(view_of(simulation, particle)));
            const double part = static_cast<double>(sample + 1) / static_cast<double>(samples);
            const bool last = sample + 1 == samples;
            stepping.advance(simulation, last ? steps : static_cast<std::uint64_t>(part * static_cast<double>(steps)));
        }
        request.view = view_of(simulation, particle);
    }

    static void put_beside(const Simulation& leading, std::span<const RunDescription> runs, PictureRequest& request) {
        const std::vector<Simulation> others = runs_at(request.view.frame.time, runs);
        for (const Simulation& other : others)
            request.followers.push_back(view_of(other, followed_particle(leading, request)));
        if (request.panel && !others.empty()) request.errors = errors_of(leading, others);
    }

    std::optional<SnapshotEnsemble> ensemble_of(const RunDescription& description) const {
        if (!ensemble_.is_given()) return std::nullopt;
        return SnapshotEnsemble(description, ensemble_.count(), ensemble_.ranges(description));
    }

    static std::optional<std::size_t> followed_particle(const Simulation& simulation, const PictureRequest& request) {
        if (request.style.selected) return request.style.selected;
        return request.panel ? std::optional(first_followed(*simulation.shape())) : std::nullopt;
    }

    static RunView without_particles(RunView view) {
        view.frame.positions = {};
        view.frame.velocities = {};
        return view;
    }

    void print_result(const RunView& view, const std::string& gl) const {
        print(fmt::format("{}: step {}, time {} s, {} pixels, drawn with {}\n", picture_.out(), view.frame.step,
                          short_number(view.frame.time), picture_.size_text(), gl));
    }

    SceneOptions scene_{SceneOptions::Time::both};
    TimeOptions time_{0, TimeOptions::Default::scene};
    SnapshotOptions picture_;
    ShownRunsOptions runs_;
    EnsembleOptions ensemble_;
};

}  // namespace

std::unique_ptr<Command> snapshot_command() { return std::make_unique<SnapshotCommand>(); }

}  // namespace steplab
