// Which frame of a file is that of a step or a time.
#include "core/clamped.hpp"
#include "session/playback.hpp"

#include <algorithm>
#include <cmath>

namespace steplab {
namespace {

/// Of the distance of frames: a time that is written rounded is that of its frame.
constexpr double rounding_of_times = 1e-6;

}  // namespace

double Playback::spacing() const {
    return frames() > 1 ? elapsed_at(last_time_) / static_cast<double>(frames() - 1) : 0;
}

/// The last frame that is reached, if the first one is: `ahead` says how far the goal is ahead of a moment. Frames are
/// spaced evenly as a rule, so that the guess, this part of them, is right or nearly so. One that is exactly meant is
/// found without a look at the next, which may be damaged.
template <class Ahead>
std::uint64_t Playback::last_frame(double part, const Ahead& ahead) {
    const double place = part * static_cast<double>(frames() - 1);
    const auto guess = clamped_floor<std::uint64_t>(place, 0, 9'000'000'000'000'000);
    std::uint64_t first = 0, end = frames();
    for (std::uint64_t probe = std::min(guess, end - 1); first + 1 < end;) {
        const bool is_first_probe = probe == guess;
        const double way = probe == first ? 1 : ahead(file_frames_->moment(probe));
        if (way == 0) return probe;
        if (way > 0) {
            first = probe;
            probe = is_first_probe ? first + 1 : first + (end - first) / 2;
        } else {
            end = probe;
            probe = is_first_probe ? end - 1 : first + (end - first) / 2;
        }
    }
    return first;
}

/// The last one that is no later than this step.
std::uint64_t Playback::frame_of(std::uint64_t step) {
    const double part = last_step_ > 0 ? static_cast<double>(step) / static_cast<double>(last_step_) : 0;
    return last_frame(part, [&](const FrameBlock::Moment& moment) {
        return static_cast<double>(step) - static_cast<double>(moment.step);
    });
}

/// The last one that is no later than this.
std::uint64_t Playback::frame_at(double elapsed) {
    const double part = elapsed_at(last_time_) > 0 ? elapsed / elapsed_at(last_time_) : 0;
    return last_frame(part,
                      [&](const FrameBlock::Moment& moment) { return elapsed_at(moment.time) <= elapsed ? 1 : -1; });
}

double Playback::elapsed_to(const RunEnd& end) {
    const std::uint64_t frame = end.time ? frame_at_time(*end.time) : frame_of(end.step);
    return elapsed_at(file_frames_->moment(frame).time);
}

bool Playback::ends_before(const RunEnd& end) const {
    if (!end.time) return last_step_ < end.step;
    return elapsed_at(last_time_) + rounding_of_times * spacing() < elapsed_at(*end.time);
}

std::uint64_t Playback::frame_at_time(double time) {
    const double elapsed = elapsed_at(time), near = rounding_of_times * spacing();
    const double part = elapsed_at(last_time_) > 0 ? elapsed / elapsed_at(last_time_) : 0;
    return last_frame(part, [&](const FrameBlock::Moment& moment) {
        const double ahead = elapsed - elapsed_at(moment.time);
        return std::abs(ahead) <= near ? 0 : ahead;
    });
}

/// The first one that is no earlier than this.
std::uint64_t Playback::first_frame_from(double elapsed) {
    const std::uint64_t frame = frame_at(elapsed);
    return elapsed_at(file_frames_->moment(frame).time) < elapsed ? std::min(frame + 1, frames() - 1) : frame;
}

}  // namespace steplab
