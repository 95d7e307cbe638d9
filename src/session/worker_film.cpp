// What a worker plays like a film: the events of a recording, at their steps.

#include "core/clamped.hpp"
#include "core/error.hpp"
#include "session/worker_body.hpp"

#include <algorithm>
#include <utility>

namespace steplab {

/// True if a part was to be played from here on.
bool Worker::Body::begin_part() {
    std::optional<FilmPart> begun;
    {
        const std::lock_guard lock(mutex);
        begun.swap(next_part);
    }
    if (!begun) return false;
    error.clear();
    doubtful = false;
    if (!went_well([&] { play_part(*begun); })) forget_film();
    return true;
}

/// What the session was before comes back when that is undone.
void Worker::Body::play_part(const FilmPart& next_one) {
    if (!follows_film(next_one)) {
        forget_film();
        playback ? begin_in_place(next_one.recording->start) : session->handle(event::Begin{next_one.recording->start});
        film.emplace(*next_one.recording, *session);
        film_due = {};
        film_arrived = false;
        pace.forget_speed();
    }
    part = next_one;
    film_plays = true;
    session->keep_playing();
    pace.begin(Clock::now());
}

/// True if nothing else was done since the part before it ended.
bool Worker::Body::follows_film(const FilmPart& next_one) const {
    return film && part && part->recording == next_one.recording && film->handled() == next_one.from;
}

/// True on the way to where the part begins.
bool Worker::Body::hastens() const { return film && part && film_plays && film->handled() < part->from; }

Rate Worker::Body::wanted_rate() const {
    return session->goal() || hastens() ? Rate{.as_fast_as_possible = true} : session->rate();
}

void Worker::Body::pause_film() { film_plays = false; }

/// Beyond the end of a part, and backwards, the run continues by itself.
void Worker::Body::continue_film(const event::Play& play) {
    film_plays = film.has_value();
    const bool ended = film && part && film->handled() >= part->to;
    if (ended || play.backwards) forget_film();
}

void Worker::Body::forget_film() {
    film.reset();
    part.reset();
    film_plays = false;
}

void Worker::Body::end_film() {
    forget_film();
    session->stop();
}

/// Has the next event of the film happen if the run stands there; true if something did.
bool Worker::Body::show_film() {
    const auto now = Clock::now();
    if (now < film_due || session->is_behind()) return false;
    film->approach(0);  // back, where it lies behind
    if (!film->is_due()) return false;
    if (!std::exchange(film_arrived, true) && !hastens()) {
        film_due = std::max(film_due, now + clamped_seconds(film->pause(), longest_pause.count()));
        if (now < film_due) return false;
    }
    film_arrived = false;
    const bool well = went_well([this] {
        const auto difference = film->perform();
        if (difference) throw UsageError("this is not as it was recorded: " + *difference);
    });
    film_due = hastens() ? now : now + between_film_events;
    session->keep_playing();
    if (!well || (film->is_done() && !part)) end_film();
    if (part && film->handled() >= part->to) {
        pause_film();
        session->stop();
    }
    pace.forget_speed();
    pace.begin(Clock::now());
    return true;
}

/// The steps up to the next event.
std::uint64_t Worker::Body::play_film(std::uint64_t due) {
    const std::uint64_t before = session->run().step();
    session->advance(std::min(due, film->ahead()));
    return std::max(session->run().step(), before) - before;
}

}  // namespace steplab
