// A film of what a worker plays: it waits after each frame until that was taken, so that none is left out.
#include "session/worker_body.hpp"

#include <utility>

namespace steplab {

void Worker::film(std::optional<double> spacing) {
    {
        const std::lock_guard lock(body_->mutex);
        body_->gate_asked = spacing.value_or(0);
        body_->frames_done = 0;
        body_->frames_taken = 0;
        body_->frames_ready = 0;
    }
    body_->changed.notify_one();
}

void Worker::film_goes_on(std::uint64_t frames) {
    {
        const std::lock_guard lock(body_->mutex);
        body_->frames_done = frames;
    }
    body_->changed.notify_one();
}

std::uint64_t Worker::film_frames() const {
    const std::lock_guard lock(body_->mutex);
    return body_->frames_taken;
}

/// A film that was asked for begins or ends; true if a frame of this moment is due.
bool Worker::Body::answer_film() {
    const std::lock_guard lock(mutex);
    if (gate && gate->waits() && frames_done >= gate->frames()) gate->go_on();
    const auto asked_for = std::exchange(gate_asked, std::nullopt);
    if (!asked_for) return false;
    gate.reset();
    frames_ready = 0;
    if (*asked_for > 0) gate.emplace(*asked_for);
    return gate.has_value();
}

}  // namespace steplab
