#include "app/commands/record.hpp"

#include "app/cli/appearance_options.hpp"
#include "app/cli/catalogue_text.hpp"
#include "app/cli/command_line.hpp"
#include "app/cli/ensemble_options.hpp"
#include "app/cli/scene_options.hpp"
#include "app/cli/shown_runs_options.hpp"
#include "app/cli/standard_streams.hpp"
#include "app/commands/film_options.hpp"
#include "app/commands/film_times.hpp"
#include "app/commands/pictured_ensemble.hpp"
#include "app/commands/pictured_frames.hpp"
#include "app/commands/pictured_runs.hpp"
#include "app/film/film.hpp"
#include "app/offscreen/modules.hpp"
#include "core/error.hpp"
#include "core/interruption.hpp"
#include "core/number_text.hpp"
#include "core/shown.hpp"

#include <fmt/format.h>

#include <cstdint>
#include <cstdio>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace steplab {

namespace {

constexpr const char* record_examples =
    "Examples:\n"
    "  steplab record --model mesh --until 20 --out mesh.mp4\n"
    "  steplab record --model rope --until 5 --run dt=0.01 --run method=euler,dt=0.05 --out rope.webm\n"
    "  steplab record --scene figure-eight --speed 0.5 --out frames/%05d.png\n\n";

class RecordCommand final : public Command {
public:
    std::string_view name() const override { return "record"; }
    std::string_view what() const override { return "Draw a run over time as a film, without a display"; }

    void declare(CLI::App& app) override {
        scene_.declare(app);
        time_.declare(app);
        film_.declare(app);
        runs_.declare(app);
        ensemble_.declare(app);
        text_option(app, "--trajectory", trajectory_, "FILE",
                    "Draw the frames of a trajectory, CSV, extended XYZ or LAMMPS dump", "Scene");
        footer(app, [] { return record_examples + catalogue_hint(); });
    }

    int run() override { return trajectory_.empty() ? record_runs() : record_frames(); }

private:
    int record_runs() {
        const std::vector<RunDescription> runs = runs_.runs(scene_.description());
        const RunDescription& description = runs.front();
        const RunEnd end = time_.end(description);
        PictureRequest request = film_.request(description);
        check_column(request.style, {});
        runs_.put_into(request.style);
        const FilmFormat format = film_.format(request.size);
        const FilmTimes times(description, end, time_.end_time(description), film_.spacing());
        catch_interruptions();
        std::optional<PicturedEnsemble> ensemble = pictured_ensemble(ensemble_, description);
        Offscreen offscreen(film_.gl());
        const std::unique_ptr<Film> film = make_film(format);
        PicturedRuns pictured(runs, times.end(), std::move(request), std::move(ensemble), "steplab record");
        const auto go_to = [&](std::uint64_t frame) -> std::optional<bool> {
            if (pictured.is_over()) return std::nullopt;
            return pictured.go_to(times.step(frame));
        };
        const std::uint64_t frames = write(pictured, times.count(), go_to, offscreen, *film);
        for (const std::string& note : pictured.notes()) print_note("steplab record", note);
        if (const auto note = times.note()) print_note("steplab record", *note);
        print_result(frames, format.fps, offscreen.kind());
        pictured.check_ends();
        return static_cast<int>(ExitCode::done);
    }

    int record_frames() {
        if (scene_.any_given() || ensemble_.is_given() || runs_.are_given()) refuse_scene_beside(trajectory_);
        catch_interruptions();
        const PlayedStart start = played_start(trajectory_);
        PictureRequest request = film_.request(start.run, start.particles);
        check_column(request.style, start.columns);
        const FilmFormat format = film_.format(request.size);
        Offscreen offscreen(film_.gl());
        PicturedFrames played(trajectory_, std::move(request), "steplab record");
        const double spacing = film_.spacing();
        const double length = time_.is_given() ? played.length_to(time_.moment(start.run)) : played.length();
        const std::uint64_t count = film_frames(length, spacing);
        const std::unique_ptr<Film> film = make_film(format);
        const auto go_to = [&](std::uint64_t frame) -> std::optional<bool> {
            return played.go_to(static_cast<double>(frame) * spacing);
        };
        print_result(write(played, count, go_to, offscreen, *film), format.fps, offscreen.kind());
        const RunEnd all{.step = std::numeric_limits<std::uint64_t>::max()};
        const RunEnd end = time_.is_given() ? time_.moment(start.run) : all;
        if (time_.is_given() && played.ends_before(end)) print_note("steplab record", played.end_note());
        const std::string fault = played.fault_before(end);
        if (!fault.empty())
            throw FileError(fmt::format("'{}': {}; the film is of the frames before that", shown(trajectory_), fault));
        return static_cast<int>(ExitCode::done);
    }

    /// Every frame of the film. `go_to` takes the pictures to that of a frame: false where that is the one before,
    /// nothing where there are no more. Returns the number of frames.
    template <class Pictures, class GoTo>
    static std::uint64_t write(Pictures& pictures, std::uint64_t count, GoTo go_to, Offscreen& offscreen, Film& film) {
        Picture picture;
        std::uint64_t frame = 0;
        try {
            for (; frame < count; ++frame) {
                const std::optional<bool> moved = go_to(frame);
                if (!moved) break;
                const bool repeated = !*moved && frame > 0;
                if (!repeated) picture = offscreen.draw(pictures.request());
                // That of a word such as `default` would be another one for each frame.
                if (frame == 0) pictures.keep_camera(picture.camera);
                film.add(picture, repeated);
            }
            film.finish();
        } catch (const Interrupted&) {
            pictures.end_progress();
            print_aside(fmt::format("steplab record: interrupted; {}\n", film.keep()));
            throw;
        } catch (const FileError& error) {
            pictures.end_progress();
            throw FileError(fmt::format("{}; {}", error.what(), film.keep()));
        }
        pictures.end_progress();
        return frame;
    }

    void print_result(std::uint64_t frames, double fps, const std::string& gl) const {
        print(fmt::format("{}: {} frame{}, {} s, {} pixels, drawn with {}\n", shown(film_.out()), frames,
                          frames == 1 ? "" : "s", short_number(static_cast<double>(frames) / fps), film_.size_text(),
                          gl));
    }

    SceneOptions scene_{SceneOptions::Time::both};
    TimeOptions time_{1000, TimeOptions::Default::scene};
    FilmOptions film_;
    ShownRunsOptions runs_;
    EnsembleOptions ensemble_;
    std::string trajectory_;
};

}  // namespace

std::unique_ptr<Command> record_command() { return std::make_unique<RecordCommand>(); }

}  // namespace steplab
