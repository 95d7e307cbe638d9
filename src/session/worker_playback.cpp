#include "core/clamped.hpp"
#include "core/freed_memory.hpp"
#include "session/worker_body.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace steplab {

namespace {

/// Frames that follow faster are left out: pictures do not come more often.
constexpr std::chrono::milliseconds shortest{8};
/// How soon it is seen that another program has written more.
constexpr std::chrono::milliseconds between_looks{250};

}  // namespace

/// What there was before is given up only if that can begin.
void Worker::Body::begin(const Beginning& beginning) {
    std::unique_ptr<Session> begun;
    std::unique_ptr<Playback> opened;
    const auto* const recorded = std::get_if<Recording>(&beginning);
    if (const auto* const file = std::get_if<TrajectoryFile>(&beginning)) {
        opened = std::make_unique<Playback>(file->path);
    } else {
        begun = std::make_unique<Session>(recorded ? recorded->start : std::get<RunDescription>(beginning));
        begun->record(hashed);
    }
    forget_film();
    session = std::move(begun);
    playback = std::move(opened);
    give_back_freed_memory();
    if (recorded) film.emplace(*recorded, *session);
    if (film && film->is_done()) film.reset();  // nothing happened
    frames_since = {Clock::now(), 0};
    moved = Clock::now();
    film_arrived = false;
    film_due = {};
    pace = Pace();
    pace.begin(Clock::now());
}

/// In place of what was played, with what stays from then.
void Worker::Body::begin_in_place(const Beginning& beginning) {
    begin(beginning);
    errors.forget();
    runs_before = newest_run + 1;
    for (const Event& event : std::array(kept_events)) handle(event);
}

/// True if something else is played from here on.
bool Worker::Body::begin_next() {
    std::optional<Beginning> beginning;
    {
        const std::lock_guard lock(mutex);
        beginning.swap(next);
    }
    if (!beginning) return false;
    error.clear();
    doubtful = false;
    went_well([&] { begin_in_place(*beginning); });
    return true;
}

/// At the present rate.
Worker::Body::Clock::time_point Worker::Body::next_frame_due() const {
    const Clock::time_point soonest = published + shortest;
    const Rate rate = playback->rate();
    if (rate.as_fast_as_possible) return soonest;
    const double wait = std::abs(playback->next_elapsed() - frames_since.elapsed) / rate.seconds_per_second;
    return std::max(soonest, frames_since.now + clamped_seconds(wait, 3600));
}

void Worker::Body::wait_for_frame(std::unique_lock<std::mutex>& lock) {
    if (playback->has_more() || playback->lacks_samples()) return;
    auto due = playback->playing() ? next_frame_due() : Clock::time_point::max();
    if (playback->can_grow()) due = std::min(due, Clock::now() + between_looks);
    if (due == Clock::time_point::max()) return changed.wait(lock, [this] { return called(); });
    changed.wait_until(lock, due, [this] { return called(); });
}

void Worker::Body::play_frame(Clock::time_point now) {
    bool turned = false;
    if (playback->rate().as_fast_as_possible) {
        turned = playback->play_next();
    } else {
        const double since = Pace::Duration(now - frames_since.now).count() * playback->rate().seconds_per_second;
        turned = playback->play_to(frames_since.elapsed + (playback->plays_backwards() ? -since : since));
    }
    if (turned) frames_since = {now, playback->elapsed()};
}

/// Some of those that plots show. True if they are to be seen.
bool Worker::Body::sample_frames() {
    if (!playback->lacks_samples()) return false;
    const auto begin = Clock::now();
    while (playback->lacks_samples() && Clock::now() - begin < late_slice) playback->sample_on();
    return !playback->lacks_samples() || begin - published > between_late_views;
}

/// Takes the file to where the clock is. What cannot be read ends playing.
void Worker::Body::play_frames(bool to_show) {
    const auto now = Clock::now();
    const bool due = playback->playing() && next_frame_due() <= now;
    bool well = true;
    if (due) {
        well = went_well([&] { play_frame(now); });
    }
    if (!well) playback->stop();
    went_well([&] { to_show = playback->look_on() || to_show; });
    went_well([&] { to_show = sample_frames() || to_show; });
    if (to_show || due) publish(true, well);
}

}  // namespace steplab
