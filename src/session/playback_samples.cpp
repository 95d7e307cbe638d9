// What plots show of the frames of a file.
#include "core/error.hpp"
#include "core/interruption.hpp"
#include "session/playback.hpp"

namespace steplab {

/// What is not known of frames without their scene is 0.
Diagnostics Playback::measure(const Frame& frame) {
    if (!meter_) return {};
    Diagnostics measured = meter_->measure(frame);
    measured.energy_error = measured.energy - first_energy_;
    return measured;
}

void Playback::follow_tracked() {
    const TrackedParticles followed = tracked_particles(tracked_, also_tracked_);
    if (followed == samples_.followed()) return;
    samples_.follow(followed);
    sampled_frames_.restart();
    lacks_samples_ = with_samples_;
    take_sample();
}

void Playback::take_sample() {
    if (with_samples_ && sampled_frames_.has(number_)) samples_.put(sample(frame_, diagnostics_));
}

void Playback::sample_on() {
    const auto number = sampled_frames_.next(frames());
    lacks_samples_ = number.has_value();
    if (number) sample_frame(*number);
}

void Playback::sample_to_here() {
    while (const auto number = sampled_frames_.next(number_ + 1)) {
        check_interruption();
        sample_frame(*number);
    }
}

void Playback::sample_frame(std::uint64_t number) {
    try {
        file_frames_->frame(number, read_);
    } catch (const FileError&) {
        return;  // who goes there is told
    }
    if (read_.positions.size() != shape_->rest.size()) return;
    samples_.put(sample(read_, measure(read_)));
    if (with_forces_) measure(frame_);  // forces are told of what was measured last
}

Sample Playback::sample(const Frame& frame, const Diagnostics& measured) const {
    Sample sample = sample_of(frame.step, frame.time, measured);
    for (const std::size_t particle : samples_.followed()) {
        sample.particles.emplace_back();
        if (particle >= frame.positions.size()) continue;
        const Tracked now = tracked(particle, frame);
        sample.particles.back() =
            Sample::Particle{now.displacement, frame.velocities[particle], now.exact_displacement};
    }
    return sample;
}

Tracked Playback::tracked(std::size_t particle, const Frame& frame) const {
    const Vec3 rest = shape_->rest[particle];
    Tracked tracked{particle, frame.positions[particle] - rest};
    if (!meter_ || !meter_->exact()) return tracked;
    tracked.exact = {meter_->exact(), particle, frame.reference.at(particle) - rest};
    tracked.exact_displacement = tracked.exact->displacement(frame.time);
    return tracked;
}

}  // namespace steplab
