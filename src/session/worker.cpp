#include "session/worker.hpp"

#include "session/worker_body.hpp"

#include <utility>

namespace steplab {

Worker::Worker(const Beginning& beginning, std::size_t hashed) : body_(std::make_unique<Body>(beginning, hashed)) {}

Worker::~Worker() {
    {
        const std::lock_guard lock(body_->mutex);
        body_->stopping = true;
    }
    body_->changed.notify_one();
    body_->thread.join();
}

void Worker::send(const Event& event) {
    {
        const std::lock_guard lock(body_->mutex);
        auto& events = body_->events;
        if (!events.empty() && overtakes(events.back(), event)) events.pop_back();
        events.push_back(event);
    }
    body_->changed.notify_one();
}

void Worker::begin(Beginning beginning) {
    {
        const std::lock_guard lock(body_->mutex);
        body_->next = std::move(beginning);
        body_->next_part.reset();
        body_->events.clear();
    }
    body_->changed.notify_one();
}

void Worker::play_part(const FilmPart& part) {
    {
        const std::lock_guard lock(body_->mutex);
        body_->next_part = part;
    }
    body_->changed.notify_one();
}

std::future<Recording> Worker::recording() {
    std::future<Recording> recording;
    {
        const std::lock_guard lock(body_->mutex);
        recording = body_->asked.emplace_back().get_future();
    }
    body_->changed.notify_one();
    return recording;
}

bool Worker::take(SessionView& view) {
    const std::lock_guard lock(body_->mutex);
    if (!body_->fresh) return false;
    std::swap(view, body_->ready);
    body_->fresh = false;
    body_->frames_taken = body_->frames_ready;
    return true;
}

std::optional<Doubt> Worker::doubt() const {
    const std::lock_guard lock(body_->mutex);
    return body_->doubt;
}

void Worker::on_view(void (*wake)()) {
    const std::lock_guard lock(body_->mutex);
    body_->wake = wake;
}

}  // namespace steplab
