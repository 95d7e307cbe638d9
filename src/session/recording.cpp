#include "session/recording.hpp"

#include <utility>

namespace steplab {

namespace {

/// Pulls of one particle at one step leave the last one (TimeLine).
bool is_same_pull(const RecordedEvent& last, const RecordedEvent& next) {
    const auto *const before = std::get_if<event::Do>(&last.event), *const now = std::get_if<event::Do>(&next.event);
    return before && now && overwrites(now->act, before->act) && last.step == next.step;
}

}  // namespace

bool is_seek(const Event& event) { return is_any<event::Seek, event::SeekTime>(event); }

void Recording::add(RecordedEvent next, bool nothing_new) {
    RecordedEvent* const last = events.empty() ? nullptr : &events.back();
    if (complete && last && !last->diverged && !next.diverged) {
        const bool dragged = nothing_new && is_seek(last->event) && is_seek(next.event);
        const bool is_same_speed =
            is_any<event::SetRate>(last->event) && is_any<event::SetRate>(next.event) && last->step == next.step;
        if (dragged || is_same_speed || is_same_pull(*last, next)) {
            last->event = std::move(next.event);
            if (!dragged) last->hash = std::move(next.hash);
            return;
        }
    }
    complete = complete && events.size() < most_events;
    if (complete) events.push_back(std::move(next));
}

}  // namespace steplab
