// Pictures and films that a window takes of what it shows.
#include "app/cli/standard_streams.hpp"
#include "app/png.hpp"
#include "app/window/viewer.hpp"
#include "core/number_text.hpp"
#include "core/problem_text.hpp"
#include "io/output_file.hpp"
#include "ui/plot/plot_files.hpp"

#include <fmt/format.h>

#include <cstdint>
#include <filesystem>
#include <system_error>

namespace steplab {
namespace {

constexpr double film_fps = 30;
constexpr std::uint64_t most_repeated = 60 * 30;  // of one picture: a minute in which nothing moves

/// The file of a film: numbered pictures go into a folder of their own.
std::string film_name(const std::string& model, const std::string& ending) {
    if (ending != ".png") return ui::free_name({}, model, ending.substr(1));
    const std::string folder = ui::free_name({}, model, "frames");
    std::error_code error;
    std::filesystem::create_directory(folder, error);
    return folder + "/%05d.png";
}

/// What a person looks for: the file, or the folder of the pictures.
std::string shown_name(const FilmFormat& film) {
    return film.name.ends_with(".png") ? std::filesystem::path(film.name).parent_path().string() : film.name;
}

}  // namespace

/// What is chosen for pictures, as it is drawn now; or a plot alone. `even`: with sides that a film allows.
WindowPicture::Shot Viewer::shot(const ui::PixelRect& plot, bool even) {
    const ui::PixelRect scene = interface_.scene();
    const ui::PictureChoice& choice = interface_.picture_choice();
    const ui::Display& display = interface_.display();
    WindowPicture::Shot shot{painted_.texture, scene, &interface_.draw_data(), plot};
    if (plot.width > 0) return shot;
    shot.part = choice.scene_alone ? scene : ui::PixelRect{0, 0, display.width, display.height};
    if (choice.scene_alone) shot.panels = nullptr;
    if (choice.caption) {
        const ui::Display above{shot.part.width, shot.part.height, display.scale};
        shot.caption_height = caption_.lay_out(*view_, style_, above, {choice.caption_text});
        shot.caption = &caption_;
    }
    if (!even) return shot;
    shot.part.width -= shot.part.width % 2;
    shot.part.height -= (shot.part.height + shot.caption_height) % 2;
    return shot;
}

void Viewer::save_snapshot(const ui::Request& request) {
    if (painted_.enlarged > 1) {  // of the picture in full, which is drawn now
        movement_.end();
        delayed_ = request;
        frames_wanted_ = std::max(frames_wanted_, 1);
        return;
    }
    const std::string name =
        request.file.empty() ? ui::free_name({}, view_->leading.description.model, "png") : request.file;
    const ui::Stage stage{camera_, style_, painted_.view.get()};
    ui::PixelRect plot;
    request.plot.empty() ? interface_.draw_picture(*view_, stage)
                         : void(plot = interface_.draw_plot_picture(*view_, stage, request.plot));
    try {
        const Picture picture = picture_.read(shot(plot, false));
        OutputFile out(name);
        out.write(encode_png(picture.size.width, picture.size.height, picture.rgba));
        out.commit();
        interface_.notify_saved(name);
    } catch (const std::exception& error) {  // also where there is no memory for it
        interface_.report_error(problem_text(error));
    }
    frames_wanted_ = std::max(frames_wanted_, 1);
    trace_.report("saved", name);
}

/// Of what is played from now on. Its frames are as far apart as the speed that is set says.
void Viewer::begin_film() {
    if (view_->playback) return interface_.report_error("films are taken of runs; a trajectory that is played is none");
    try {
        const WindowPicture::Shot first = shot({}, true);
        const render::PictureSize size{first.part.width, first.part.height + first.caption_height};
        const std::string name = film_name(view_->leading.description.model, interface_.picture_choice().film);
        film_ = std::make_unique<FilmRecorder>(FilmFormat{name, size, film_fps}, &Window::wake);
    } catch (const std::exception& error) {
        return interface_.report_error(problem_text(error));
    }
    worker_->film(view_->leading.rate.seconds_per_second / film_fps);
    interface_.show_film(ui::FilmStatus{});
    trace_.report("film", "begun");
}

void Viewer::end_film() {
    worker_->film(std::nullopt);
    film_->end();
}

/// The frame that is shown, if the film waits for it and all of it is drawn.
void Viewer::take_film_frame() {
    if (!film_ || !film_->is_ready()) return;
    const std::uint64_t frames = worker_->film_frames();
    if (frames <= film_->frames() || painted_.view != view_ || painted_.enlarged > 1) return;
    if (!interface_.picture_choice().scene_alone)
        interface_.draw_picture(*view_, {camera_, style_, painted_.view.get()});
    const WindowPicture::Shot frame = shot({}, true);
    const render::PictureSize size{frame.part.width, frame.part.height + frame.caption_height};
    if (size != film_->format().size) {
        interface_.notify("the film ends: its pictures are of one size");
        return end_film();
    }
    if (film_->frames() > 0 && frames - film_->frames() > most_repeated) {
        interface_.report_error(fmt::format(
            "the film ends: until the next step, one picture would be shown for {} s; a larger speed or a smaller dt "
            "moves it",
            typed(static_cast<double>(frames - film_->frames()) / film_fps, 3)));
        return end_film();
    }
    film_->add(picture_.read(frame), frames);
    worker_->film_goes_on(frames);
    interface_.show_film(ui::FilmStatus{frames, static_cast<double>(frames) / film_fps});
    trace_.report("film", std::to_string(frames) + " step " + std::to_string(view_->leading.frame.step));
}

/// Whether a picture was written, and the film once it is over.
void Viewer::take_film_news() {
    if (!film_) return;
    if (!film_->is_over()) {
        // where nothing is drawn, the film waits
        const bool drawn = painted_.view == view_ && painted_.enlarged <= 1 && !interface_.shows_scenes() &&
                           window_.display().width > 0 && window_.display().height > 0;
        const bool waits = film_->is_ready() && worker_->film_frames() > film_->frames();
        if (drawn && waits) frames_wanted_ = std::max(frames_wanted_, 1);
        return;
    }
    std::string failure = film_->failure();
    if (!failure.empty()) {
        worker_->film(std::nullopt);
        interface_.report_error(failure);
    } else {
        interface_.notify_saved(shown_name(film_->format()));
    }
    trace_.report("film", failure.empty() ? "saved " + shown_name(film_->format()) : "failed");
    film_.reset();
    interface_.show_film(std::nullopt);
    frames_wanted_ = std::max(frames_wanted_, 1);
}

/// Completes the file of a window that is closed; why it could not, if so. That may take some seconds, in which a
/// second signal ends the program.
std::string Viewer::finish_film(EndWatch& watch) {
    if (!film_) return {};
    watch.wait_longer();
    if (watch.signal()) print_aside("steplab-view: completing the film; a second signal ends it at once\n");
    worker_->film(std::nullopt);
    film_->finish();
    std::string failure = film_->failure();
    trace_.report("film", failure.empty() ? "saved " + shown_name(film_->format()) : "failed");
    film_.reset();
    return failure;
}

}  // namespace steplab
