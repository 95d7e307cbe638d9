#include "app/commands/snapshot.hpp"

#include "app/cli/appearance_options.hpp"
#include "app/cli/command_line.hpp"
#include "app/cli/ensemble_options.hpp"
#include "app/cli/scene_options.hpp"
#include "app/cli/shown_runs_options.hpp"
#include "app/cli/standard_streams.hpp"
#include "app/commands/pictured_ensemble.hpp"
#include "app/commands/pictured_frames.hpp"
#include "app/commands/pictured_runs.hpp"
#include "app/commands/snapshot_options.hpp"
#include "app/png.hpp"
#include "core/error.hpp"
#include "core/interruption.hpp"
#include "core/number_text.hpp"
#include "core/shown.hpp"
#include "io/output_file.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace steplab {

namespace {

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
        text_option(app, "--trajectory", trajectory_, "FILE",
                    "Draw a frame of a trajectory, CSV, extended XYZ or LAMMPS dump, the one at --steps or --until",
                    "Scene");
    }

    int run() override {
        if (!trajectory_.empty()) return draw_frame();
        const std::vector<RunDescription> runs = runs_.runs(scene_.description());
        const RunDescription& description = runs.front();
        const RunEnd end = time_.end(description);
        PictureRequest request = picture_.request(description);
        check_column(request.style, {});
        runs_.put_into(request.style);
        catch_interruptions();
        std::optional<PicturedEnsemble> ensemble = pictured_ensemble(ensemble_, description);
        OutputFile file(picture_.out());
        Offscreen offscreen(picture_.gl());
        PicturedRuns pictured(runs, end, std::move(request), std::move(ensemble));
        pictured.go_to(end.step);
        const Picture picture = offscreen.draw(pictured.request());
        pictured.end_progress();
        file.write(encode_png(picture.size.width, picture.size.height, picture.rgba));
        file.commit();
        for (const std::string& note : pictured.notes()) print_note("steplab snapshot", note);
        if (const auto note = time_.note(description, end)) print_note("steplab snapshot", *note);
        if (!written_directly(picture_.out())) print_result(pictured.request().view, offscreen.kind());
        pictured.check_ends();
        return static_cast<int>(ExitCode::done);
    }

private:
    int draw_frame() {
        if (scene_.any_given() || ensemble_.is_given() || runs_.are_given()) refuse_scene_beside(trajectory_);
        catch_interruptions();
        const PlayedStart start = played_start(trajectory_);
        const RunEnd end = time_.moment(start.run);
        PictureRequest request = picture_.request(start.run, start.particles);
        check_column(request.style, start.columns);
        OutputFile file(picture_.out());
        Offscreen offscreen(picture_.gl());
        PicturedFrames frames(trajectory_, std::move(request));
        frames.go_to(end);
        const Picture picture = offscreen.draw(frames.request());
        file.write(encode_png(picture.size.width, picture.size.height, picture.rgba));
        file.commit();
        if (!written_directly(picture_.out())) print_result(frames.request().view, offscreen.kind());
        if (frames.ends_before(end)) print_note("steplab snapshot", frames.end_note());
        if (const std::string fault = frames.fault_before(end); !fault.empty())
            throw FileError(fmt::format("'{}': {}; the picture is of step {}, before that", shown(trajectory_), fault,
                                        frames.request().view.frame.step));
        return static_cast<int>(ExitCode::done);
    }

    void print_result(const RunView& view, const std::string& gl) const {
        print(fmt::format("{}: step {}, time {} s, {} pixels, drawn with {}\n", shown(picture_.out()), view.frame.step,
                          short_number(view.frame.time), picture_.size_text(), gl));
    }

    SceneOptions scene_{SceneOptions::Time::both};
    TimeOptions time_{0, TimeOptions::Default::scene};
    SnapshotOptions picture_;
    ShownRunsOptions runs_;
    EnsembleOptions ensemble_;
    std::string trajectory_;
};

}  // namespace

std::unique_ptr<Command> snapshot_command() { return std::make_unique<SnapshotCommand>(); }

}  // namespace steplab
