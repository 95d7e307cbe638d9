#include "app/window/painter.hpp"

#include "app/cli/driver_needs.hpp"
#include "app/offscreen/context.hpp"
#include "app/shown_runs.hpp"
#include "app/window/priority.hpp"
#include "core/error.hpp"
#include "render/gl.hpp"
#include "render/motion.hpp"
#include "render/scene_renderer.hpp"

#include <fmt/format.h>

#include <chrono>
#include <cstdlib>
#include <utility>

namespace steplab {

using Clock = std::chrono::steady_clock;

namespace {

/// The painter's context, current on its thread: one that shares textures, or one of a driver of its own.
class CurrentContext {
public:
    explicit CurrentContext(std::optional<DrawingContext>& shared) : shared_(shared) {
        shared_ ? shared_->make_current() : open_own();
    }
    ~CurrentContext() {
        if (shared_) shared_->release();
    }
    CurrentContext(const CurrentContext&) = delete;
    CurrentContext& operator=(const CurrentContext&) = delete;

private:
    void open_own() {
        require_space_to_draw(driver_space);
        try {
            own_.emplace();
        } catch (const GraphicsError& error) {
            throw GraphicsError(
                fmt::format("{}: Mesa's software renderer draws the scene through EGL, in the Debian "
                            "packages libegl1 and libegl-mesa0",
                            error.what()));
        }
    }

    std::optional<DrawingContext>& shared_;
    std::optional<OffscreenContext> own_;
};

}  // namespace

/// The objects in the painter's context: the renderer and its target.
class Painting {
public:
    /// `copies`: the window cannot have the textures.
    explicit Painting(bool copies) : copies_(copies) {}

    /// Returns when the picture is complete: one that is shown unfinished would hold up the panels.
    void draw(const PaintJob& job) {
        if (!target_ || target_->size() != job.size) target_.emplace(job.size);
        const std::vector<render::ShownRun> runs = moment(job);
        renderer_.draw(runs, job.style, camera_at(*runs.front().frame, job), *target_);
        copies_ ? target_->copy_into(copied_) : render::Fence::after_commands().wait();
    }
    /// Puts the picture in the place of another one, and draws over that once it is not shown any more.
    void hand_over(Painted& picture) {
        if (copies_) return std::swap(picture.copied, copied_);
        std::exchange(picture.shown, {}).delay_commands();
        target_->exchange(picture.texture);
    }

private:
    /// The runs at the moment of the job.
    std::vector<render::ShownRun> moment(const PaintJob& job) {
        const SessionView& now = *job.view;
        std::vector<render::ShownRun> runs = shown_runs(now.leading, now.followers);
        if (!job.from) return runs;
        const SessionView& before = *job.from;
        between_.resize(runs.size());
        for (std::size_t i = 0; i < runs.size(); ++i) {
            const RunView* const earlier = i == 0                         ? &before.leading
                                           : i <= before.followers.size() ? &before.followers[i - 1]
                                                                          : nullptr;
            if (!earlier || !can_glide(earlier->frame, *runs[i].frame)) continue;
            render::between(earlier->frame, *runs[i].frame, job.fraction, between_[i]);
            runs[i].frame = &between_[i];
        }
        return runs;
    }

    /// A run that was added or begun again meanwhile is shown where it is; so is one that took no step.
    static bool can_glide(const Frame& from, const Frame& to) { return from.shape == to.shape && to.time > from.time; }

    /// Where the camera is when what it goes with is where it is in this frame.
    static render::Camera camera_at(const Frame& frame, const PaintJob& job) {
        render::Camera camera = job.camera;
        const auto here = render::followed_point(frame, job.following, job.style.selected);
        const auto there = render::followed_point(job.view->leading.frame, job.following, job.style.selected);
        if (here && there) camera.focus = camera.focus + (*here - *there);
        return camera;
    }

    bool copies_;
    render::TexturePixels copied_;
    std::vector<Frame> between_;  ///< by run; kept to reuse their memory
    render::SceneRenderer renderer_;
    std::optional<render::RenderTarget> target_;
};

ScenePainter::ScenePainter(const Window& window, void (*wake)()) : wake_(wake) {
    if (render::draws_on_several_threads()) {
        shared_.emplace(window);
    } else {
        setenv("LIBGL_ALWAYS_SOFTWARE", "1", 1);  // like the window: a card that EGL may find has perhaps no OpenGL 3.3
    }
    thread_ = std::thread([this] { work(); });
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return started_ || failure_; });
    if (!failure_) return;
    lock.unlock();
    thread_.join();
    std::rethrow_exception(failure_);
}

ScenePainter::~ScenePainter() {
    {
        const std::lock_guard lock(mutex_);
        stopping_ = true;
    }
    changed_.notify_all();
    thread_.join();
}

bool ScenePainter::ask(const PaintJob& job, Clock::time_point now) {
    {
        const std::lock_guard lock(mutex_);
        if (last_ == job) return false;
        last_ = job;
        asked_ = Request{job, now};
    }
    changed_.notify_all();
    return true;
}

bool ScenePainter::take(Painted& picture) {
    {
        const std::lock_guard lock(mutex_);
        if (failure_) std::rethrow_exception(failure_);
        if (!fresh_) return false;
        if (shared_) picture.shown = render::Fence::after_commands();
        std::swap(picture, ready_);
        fresh_ = false;
    }
    if (!shared_) picture.texture.upload(picture.copied);
    return true;
}

void ScenePainter::work() {
    lower_priority(ThreadWork::pictures);
    try {
        const CurrentContext context(shared_);
        Painting painting(!shared_);
        {
            const std::lock_guard lock(mutex_);
            started_ = true;
        }
        changed_.notify_all();
        draw_jobs(painting);
    } catch (...) {
        const std::lock_guard lock(mutex_);
        failure_ = std::current_exception();
    }
    changed_.notify_all();
    wake_();
}

/// Draws until the window closes.
void ScenePainter::draw_jobs(Painting& painting) {
    while (const auto request = next_request()) {
        const auto begin = Clock::now();
        painting.draw(request->job);
        finish(painting, *request, std::chrono::duration<double>(Clock::now() - begin).count());
    }
}

/// Waits for one; none when the painter has to stop.
std::optional<ScenePainter::Request> ScenePainter::next_request() {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return stopping_ || asked_; });
    if (stopping_) return std::nullopt;
    return std::exchange(asked_, std::nullopt);
}

void ScenePainter::finish(Painting& painting, const Request& request, double seconds) {
    {
        const std::lock_guard lock(mutex_);
        painting.hand_over(ready_);
        ready_.requested = request.time;
        ready_.seconds = seconds;
        ready_.enlarged = request.job.style.enlarged;
        ready_.view = request.job.view;
        fresh_ = true;
    }
    wake_();
}

}  // namespace steplab
