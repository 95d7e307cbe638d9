#pragma once

#include "app/cli/view_options.hpp"
#include "app/film/film_recorder.hpp"
#include "app/window/caption_strip.hpp"
#include "app/window/frame_beat.hpp"
#include "app/window/frame_count.hpp"
#include "app/window/gallery_loader.hpp"
#include "app/window/painter.hpp"
#include "app/window/scene_files.hpp"
#include "app/window/trace.hpp"
#include "app/window/view_pool.hpp"
#include "app/window/window.hpp"
#include "app/window/window_picture.hpp"
#include "core/end_watch.hpp"
#include "io/output_file.hpp"
#include "session/worker.hpp"
#include "ui/coarseness.hpp"
#include "ui/glide.hpp"
#include "ui/interface.hpp"
#include "ui/movement.hpp"

#include <chrono>
#include <cstdint>
#include <future>
#include <memory>
#include <optional>
#include <vector>

namespace steplab {

/// The program of the window: the worker computes, the painter draws the scene, and this thread draws the panels over
/// the newest picture and forwards the input. It sleeps while nothing happens.
class Viewer {
public:
    /// Throws GraphicsError if there is no display, no OpenGL 3.3 or a shader is missing.
    Viewer(const RunDescription& description, const WindowRequest& request);

    /// Runs until the window is closed, or a signal asks it to end. Throws FileError if a file that is completed then
    /// cannot be.
    void run(EndWatch& watch);

private:
    using Clock = std::chrono::steady_clock;

    /// Loads OpenGL in the context of the window; constructed after the window and before everything that draws.
    struct OpenGl {
        OpenGl();
    };

    void open(const WindowRequest& request);
    void place_camera(const WindowRequest& request);
    void begin_as_asked();
    ui::ViewChoices choices() const;
    void remember_choices() const;
    void finish_ended_session();
    void tell_of_film();
    void take_news();
    void take_files();
    void take(const SceneFiles::News& news);
    void take_gallery();
    void wait();
    void draw_frame();
    void show();
    void ask_for_scene(Clock::time_point now);
    int enlarged(Clock::time_point now, const ui::PixelRect& scene);
    void carry_out(const ui::Request& request);
    void save_snapshot(const ui::Request& request);
    void show_page(const std::string& name);
    WindowPicture::Shot shot(const ui::PixelRect& plot, bool even);
    void begin_film();
    void end_film();
    void take_film_frame();
    void take_film_news();
    std::string finish_film(EndWatch& watch);
    void save_scene();
    void save_session();
    void begin(Beginning beginning);
    void report();

    WindowSystem system_;
    Window window_;
    OpenGl opengl_;
    ui::Interface interface_;
    WindowPicture picture_;
    CaptionStrip caption_;
    Painted painted_;
    ScenePainter painter_;
    Trace trace_;
    FrameCount counted_;
    GalleryLoader gallery_;
    SceneFiles files_;
    SceneOrigin watched_;  ///< the scene whose file is watched
    /// A session in whose place something else is to be played.
    struct EndedSession {
        std::shared_future<Recording> recording;
        std::uint64_t run = 0, failures = 0;  ///< of its last view
    };

    std::shared_ptr<OutputFile> session_file_;  ///< to which what happens is written at the end; null: none
    std::optional<EndedSession> ended_;
    std::string choices_file_;                       ///< empty: choices are not remembered
    std::optional<ui::ViewChoices> opened_choices_;  ///< of the first frame
    ViewPool pool_;
    std::unique_ptr<Worker> worker_;
    std::shared_ptr<SessionView> view_;
    ui::Glide glide_;
    render::Camera camera_;
    render::Style style_;
    std::optional<WindowRequest> opening_;  ///< until the run has reached the step to open at
    bool under_way_ = false;                ///< to that step
    ui::Measured measured_;
    ui::Coarseness coarseness_;
    ui::Movement movement_;
    render::Camera asked_camera_;         ///< of the last picture
    ui::PixelRect asked_scene_;           ///< its place
    bool coarse_ = false;                 ///< the last request was
    std::optional<ui::Request> delayed_;  ///< to save a picture, once the scene is drawn in full
    FrameBeat beat_{Clock::now()};
    Clock::time_point change_ = Clock::time_point::max();  ///< when the picture changes without input
    int frames_wanted_ = 3;
    std::unique_ptr<FilmRecorder> film_;  ///< that is taken, or completed
    bool quit_ = false;
};

}  // namespace steplab
