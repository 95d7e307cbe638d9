#include "app/window/viewer.hpp"

#include "app/window/priority.hpp"
#include "core/error.hpp"
#include "core/number_text.hpp"
#include "render/colouring.hpp"
#include "render/framing.hpp"
#include "render/gl.hpp"
#include "session/session_file.hpp"

#include <algorithm>
#include <future>
#include <limits>
#include <utility>

namespace steplab {
namespace {

// A click reaches the panels in one frame; a widget that it opens has its final size two frames later.
constexpr int frames_after_input = 3;
// Interpolated pictures between two steps are drawn only if a picture takes less than this.
constexpr double slow_picture = 0.05;
// More would take seconds where the processor draws; the picture says what it leaves out.
constexpr std::size_t most_dots = 2'000'000;

double seconds(std::chrono::steady_clock::duration duration) { return std::chrono::duration<double>(duration).count(); }

Beginning beginning_of(const RunDescription& description, const GivenSession& session) {
    if (!session.trajectory.empty()) return TrajectoryFile{session.trajectory};
    if (session.film) return *session.film;
    return description;
}

/// The thread of the run inherits the priority of the thread that starts it.
std::unique_ptr<Worker> start_worker(const RunDescription& description, const GivenSession& session) {
    const std::size_t hashed =
        session.record_to.empty() ? Worker::most_hashed : std::numeric_limits<std::size_t>::max();
    return std::async(std::launch::async,
                      [&] {
                          lower_priority(ThreadWork::runs);
                          return std::make_unique<Worker>(beginning_of(description, session), hashed);
                      })
        .get();
}

bool same_direction(const render::Camera& a, const render::Camera& b) {
    return a.distance == b.distance && a.yaw == b.yaw && a.pitch == b.pitch;
}

}  // namespace

Viewer::OpenGl::OpenGl() { render::load_opengl(); }

Viewer::Viewer(const RunDescription& description, const WindowRequest& request)
    : window_(request.width, request.height, request.scale),
      interface_(window_.display()),
      painter_(window_, &Window::wake),
      trace_(request.trace),
      files_(&Window::wake),
      worker_(start_worker(description, request.session)) {
    if (!request.session.record_to.empty()) session_file_ = std::make_shared<OutputFile>(request.session.record_to);
    window_.listen(interface_.input());
    interface_.use_clipboard({[this] { return window_.pasted(); }, [this](const auto& text) { window_.copy(text); }});
    worker_->on_view(&Window::wake);
    open(request);
    if (request.full_screen) window_.toggle_full_screen();
}

void Viewer::run(EndWatch& watch) {
    while (!quit_ && !window_.closing() && !watch.signal()) {
        take_news();
        if (frames_wanted_ > 0 && Clock::now() >= beat_.due()) {
            window_.wait(0);  // where frames take longer than their time there is no other wait
            draw_frame();
        } else {
            wait();
        }
    }
    const std::string failure = finish_film(watch);
    save_session();
    remember_choices();
    if (!failure.empty()) throw FileError(failure);
}

/// What happened, to the file that was named. A long step under way is given up.
void Viewer::save_session() {
    if (!session_file_) return;
    std::future<Recording> recording = worker_->recording();
    if (recording.wait_for(std::chrono::milliseconds(300)) != std::future_status::ready) worker_.reset();
    session_file_->write(session_text(recording.get()));
    session_file_->commit();
}

/// In place of what is played. A session that is recorded into a file ends there.
void Viewer::begin(Beginning beginning) {
    if (session_file_) ended_ = EndedSession{worker_->recording(), view_->leading.run, view_->leading.failures};
    const bool film = std::holds_alternative<Recording>(beginning);
    worker_->begin(std::move(beginning));
    interface_.close_scenes();
    opening_.reset();
    if (!film) return;
    worker_->send(event::Play{true});
    tell_of_film();
}

/// Takes newer views of the run and pictures of the scene; each requires a frame.
void Viewer::take_news() {
    auto newer = pool_.free_view();
    if (worker_->take(*newer)) {
        view_ = std::move(newer);
        finish_ended_session();
        interface_.record(view_->leading);
        glide_.arrived(view_, Clock::now());
        begin_as_asked();
        frames_wanted_ = std::max(frames_wanted_, 1);
    }
    if (interface_.show_doubt(worker_->doubt())) frames_wanted_ = std::max(frames_wanted_, 1);
    take_files();
    take_gallery();
    take_film_news();
    if (painter_.take(painted_)) {
        counted_.took_picture();
        measured_.frame_seconds = painted_.seconds;
        coarseness_.took(painted_.enlarged, painted_.seconds);
        movement_.pictured(painted_.requested, painted_.enlarged > 1, Clock::now());
        if (delayed_) save_snapshot(*std::exchange(delayed_, std::nullopt));
        frames_wanted_ = std::max(frames_wanted_, 1);
        beat_.hurry();
        picture_.forget_scene();
    }
}

/// The recorded session, once something else is played in its place; if that could not begin, it goes on.
void Viewer::finish_ended_session() {
    if (!ended_) return;
    const bool replaced = view_->leading.run != ended_->run;
    if (replaced) files_.finish_session(std::move(session_file_), std::move(ended_->recording));
    if (replaced || view_->leading.failures > ended_->failures) ended_.reset();
}

void Viewer::tell_of_film() {
    interface_.notify("a recorded session: Space pauses it, and what you change takes its place");
}

/// What was dropped onto the window, and what became of files.
void Viewer::take_files() {
    for (const std::string& file : window_.take_dropped()) files_.open(file);
    if (view_ && !view_->playback && watched_ != view_->leading.description.origin) {
        watched_ = view_->leading.description.origin;
        files_.watch(view_->leading.description);
    }
    while (const auto news = files_.take()) {
        take(*news);
        frames_wanted_ = std::max(frames_wanted_, 1);
    }
}

void Viewer::take(const SceneFiles::News& news) {
    switch (news.kind) {
        case SceneFiles::News::Kind::opened:
            return interface_.open(*news.scene, *worker_);
        case SceneFiles::News::Kind::read_again:
            return view_->playback ? void() : interface_.reload(*news.scene, *worker_);
        case SceneFiles::News::Kind::session:
            return begin(*news.session);
        case SceneFiles::News::Kind::trajectory:
            return begin(TrajectoryFile{news.text});
        case SceneFiles::News::Kind::lesson:
            return interface_.open_lesson(*news.lesson);
        case SceneFiles::News::Kind::saved:
            interface_.notify_saved(news.text);
            return trace_.report("saved", news.text);
        case SceneFiles::News::Kind::failed:
            interface_.report_error(news.text);
            return trace_.report("refused", news.text);
    }
}

void Viewer::take_gallery() {
    if (interface_.shows_scenes()) gallery_.begin(&Window::wake);
    auto gallery = gallery_.take();
    if (!gallery) return;
    picture_.forget_panels();
    interface_.show_gallery(std::move(gallery->scenes));
    interface_.show_lessons(std::move(gallery->lessons));
    frames_wanted_ = std::max(frames_wanted_, 1);
}

void Viewer::wait() {
    const auto now = Clock::now();
    if (frames_wanted_ > 0) {
        window_.wait(std::max(1e-4, seconds(beat_.due() - now)));
    } else {
        window_.wait(change_ == Clock::time_point::max() ? 1e9 : std::max(1e-3, seconds(change_ - now)));
    }
    if (window_.take_touched()) {
        frames_wanted_ = frames_after_input;
        beat_.hurry();
    }
    if (Clock::now() >= change_) frames_wanted_ = std::max(frames_wanted_, 1);
}

void Viewer::draw_frame() {
    const auto now = Clock::now();
    measured_.since_last_frame = std::max(1e-4, seconds(beat_.draw(now)));
    --frames_wanted_;
    const ui::Display display = window_.display();
    trace_.report("size", std::to_string(display.width) + "x" + std::to_string(display.height));
    if (display.width <= 0 || display.height <= 0) return;  // minimised
    if (interface_.resize(display)) picture_.upload_fonts(interface_.fonts());
    interface_.draw(*view_, *worker_, {camera_, style_, painted_.view.get()}, measured_);
    if (!opened_choices_) opened_choices_ = choices();
    ask_for_scene(now);
    show();
    take_film_frame();
    for (const ui::Request& request : interface_.take_requests()) carry_out(request);
    const double still = interface_.seconds_until_change();
    if (still <= 0) frames_wanted_ = frames_after_input;
    change_ = still < 1e6 ? now + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(still))
                          : Clock::time_point::max();
    if (coarse_) change_ = std::min(change_, movement_.rest());
    report();
}

/// Not what looks as it did, unless the window has lost it.
void Viewer::show() {
    const bool exposed = window_.take_exposed();
    if (!picture_.draw(painted_.texture, interface_.scene(), interface_.draw_data())) {
        if (!exposed) return;
        picture_.repeat();
    }
    window_.show_picture();
    beat_.show();
    counted_.drew_frame();
}

void Viewer::ask_for_scene(Clock::time_point now) {
    if (interface_.shows_scenes()) return;
    const ui::PixelRect scene = interface_.scene();
    const bool gliding = !film_ && measured_.frame_seconds < slow_picture && glide_.gliding(now);
    const auto from = gliding ? glide_.from(now) : nullptr;
    PaintJob job{.view = view_,
                 .from = from,
                 .fraction = gliding ? glide_.fraction(now) : 1,
                 .style = style_,
                 .camera = camera_,
                 .following = interface_.following(),
                 .size = {}};
    job.style.enlarged = enlarged(now, scene);
    job.style.pixel_scale /= job.style.enlarged;
    job.style.most_dots = film_ ? 0 : most_dots;
    const auto pixels = [&](int length) { return (length + job.style.enlarged - 1) / job.style.enlarged; };
    job.size = {pixels(scene.width), pixels(scene.height)};
    movement_.requested(now, painter_.ask(job, now));
    if (gliding) frames_wanted_ = std::max(frames_wanted_, 1);
}

/// Where the picture is a coarse one, it is drawn again once the camera or what is dragged has come to rest.
int Viewer::enlarged(Clock::time_point now, const ui::PixelRect& scene) {
    const render::Camera before = std::exchange(asked_camera_, camera_);
    const bool follows = interface_.following() != render::Following::nothing;
    const bool moved = follows ? !same_direction(before, camera_) : before != camera_;
    const bool same_place = std::exchange(asked_scene_, scene) == scene;  // else the camera was moved to suit it
    if ((moved && same_place) || interface_.is_dragging()) movement_.seen(now);
    const int enlarged = delayed_ || film_ ? 1 : coarseness_.next(movement_.goes_on(now));  // in full to be saved
    coarse_ = enlarged > 1;
    return enlarged;
}

void Viewer::save_scene() {
    if (view_->playback && !view_->playback->measured)
        return interface_.report_error("the file does not hold all particles of a scene that could be saved");
    files_.save(view_->leading.description,
                {render::view_text(camera_), std::string(id(style_.colouring)), std::string(id(style_.background))});
}

void Viewer::report() {
    if (!trace_.wanted()) return;
    trace_.report(*view_);
    trace_.report(camera_);
    trace_.report("textures", painter_.shares_textures() ? "shared" : "copied");
    trace_.report("lesson", interface_.lesson().empty() ? "none" : interface_.lesson());
    trace_.report("focus", interface_.focused());
    trace_.report("colour", render::colour_word(view_->leading.frame, style_));
    trace_.report("scale", number_text(interface_.choices(style_).scale));
    trace_.report(interface_.widgets(), frames_wanted_ == 0 && (interface_.shows_scenes() || painted_.view == view_));
    if (const auto drawn = counted_.news(Clock::now())) trace_.report("drawn", *drawn);
    if (painted_.view) trace_.report("pictured", std::to_string(painted_.view->leading.frame.step));
}

}  // namespace steplab
