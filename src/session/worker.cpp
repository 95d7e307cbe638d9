#include "session/worker.hpp"

#include "session/worker_body.hpp"

#include <algorithm>
#include <utility>

namespace steplab {

Worker::Worker(const RunDescription& description) : body_(std::make_unique<Body>(description)) {}

Worker::~Worker() {
    {
        const std::lock_guard lock(body_->mutex);
        body_->stopping = true;
    }
    body_->changed.notify_one();
    body_->thread.join();
}

void Worker::play(bool on) {
    body_->post([on](Body& body) { body.play(on); });
}

void Worker::step_forward() {
    body_->post([](Body& body) {
        body.playing = false;
        body.goal.reset();
        body.simulation.advance(1);
        body.history.offer(body.simulation);
    });
}

void Worker::step_back() {
    body_->post([](Body& body) { body.step_back(); });
}

void Worker::go_to(std::uint64_t step) {
    body_->post([step](Body& body) { body.goal = step; });
}

void Worker::restart() {
    body_->post([](Body& body) {
        body.goal.reset();
        body.simulation.restart();
        body.begin_anew();
        body.pace.begin(Body::Clock::now());
    });
}

void Worker::change(const RunDescription& description) {
    {
        const std::lock_guard lock(body_->mutex);
        body_->wanted = description;
    }
    body_->changed.notify_one();
}

void Worker::pull(std::size_t particle, Vec3 position) {
    body_->post([=](Body& body) { body.pull(particle, position); });
}

void Worker::show_ensemble(const LiveEnsembleOptions& ensemble) {
    body_->post([ensemble](Body& body) {
        body.show_ensemble(ensemble);
        body.pace.forget_speed();
    });
}

void Worker::show_forces(bool on) {
    body_->post([on](Body& body) { body.with_forces = on; });
}

void Worker::set_rate(Rate rate) {
    body_->post([rate](Body& body) {
        body.rate = rate;
        body.pace.begin(Body::Clock::now());
    });
}

void Worker::track(std::optional<std::size_t> particle) {
    body_->post([particle](Body& body) { body.tracked = particle; });
}

bool Worker::take(RunView& view) {
    const std::lock_guard lock(body_->mutex);
    if (!body_->fresh) return false;
    std::swap(view, body_->ready);
    body_->fresh = false;
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
