#include "app/view_painter.hpp"

#include "render/scene_renderer.hpp"

#include <chrono>
#include <utility>

namespace steplab {

using Clock = std::chrono::steady_clock;

/// What belongs to the painter's context: the renderer and what is drawn into.
class Painting {
public:
    std::uint32_t draw(const PaintJob& job, std::size_t which) {
        auto& target = targets_[which];
        if (!target || target->size() != job.size) target.emplace(job.size);
        renderer_.draw(job.view->frame, job.style, job.camera, *target);
        // The window's context may use the texture only once it is complete.
        glFinish();
        return target->texture();
    }

private:
    render::SceneRenderer renderer_;
    std::array<std::optional<render::RenderTarget>, 3> targets_;
};

ScenePainter::ScenePainter(const Window& window, void (*wake)()) : context_(window), wake_(wake) {
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

void ScenePainter::ask(const PaintJob& job) {
    {
        const std::lock_guard lock(mutex_);
        if (last_ == job) return;
        last_ = asked_ = job;
    }
    changed_.notify_all();
}

std::optional<Painted> ScenePainter::take() {
    const std::lock_guard lock(mutex_);
    if (failure_) std::rethrow_exception(failure_);
    if (!fresh_) return std::nullopt;
    fresh_ = false;
    std::swap(shown_, ready_);
    return pictures_[shown_];
}

void ScenePainter::work() {
    context_.make_current();
    try {
        Painting painting;
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
    context_.release();
}

/// Until the window closes.
void ScenePainter::draw_jobs(Painting& painting) {
    while (const auto job = next_job()) {
        const auto begin = Clock::now();
        pictures_[drawn_].texture = painting.draw(*job, drawn_);
        finish(std::chrono::duration<double>(Clock::now() - begin).count());
    }
}

/// Waits for a job; none once the painter is to stop.
std::optional<PaintJob> ScenePainter::next_job() {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return stopping_ || asked_; });
    if (stopping_) return std::nullopt;
    return std::exchange(asked_, std::nullopt);
}

void ScenePainter::finish(double seconds) {
    {
        const std::lock_guard lock(mutex_);
        pictures_[drawn_].seconds = seconds;
        std::swap(drawn_, ready_);
        fresh_ = true;
    }
    wake_();
}

}  // namespace steplab
