#include "session/replay.hpp"

#include "core/error.hpp"
#include "session/event_words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace steplab {

Replay::Replay(Recording recording, Session& session) : recording_(std::move(recording)), session_(session) {}

bool Replay::is_done() const { return next_ >= recording_.events.size() + (recording_.end ? 1 : 0); }

std::uint64_t Replay::next_step() const {
    return next_ < recording_.events.size() ? recording_.events[next_].step : recording_.end->step;
}

bool Replay::next_diverged() const {
    return next_ < recording_.events.size() ? recording_.events[next_].diverged : recording_.end->diverged;
}

/// Forward steps from one event to the next, up to that of so many events; what an event itself moves is not known
/// before.
std::uint64_t Replay::steps_to(std::size_t events) const {
    std::uint64_t sum = 0, at = 0;
    for (std::size_t i = 0; i < events; ++i) {
        const std::uint64_t step = i < recording_.events.size() ? recording_.events[i].step : recording_.end->step;
        sum += step > at ? step - at : 0;
        at = step;
    }
    return sum;
}

std::uint64_t Replay::all_steps() const { return steps_to(recording_.events.size() + (recording_.end ? 1 : 0)); }

double Replay::done() const {
    const std::uint64_t all = all_steps();
    if (is_done() || all == 0) return is_done() ? 1 : 0;
    const std::uint64_t to_next = steps_to(next_ + 1), left = std::min(ahead(), to_next);
    return static_cast<double>(to_next - left) / static_cast<double>(all);
}

bool Replay::is_due() const { return session_.run().step() == next_step() || session_.line().is_over(); }

std::uint64_t Replay::ahead() const { return next_step() - std::min(next_step(), session_.run().step()); }

void Replay::approach(std::uint64_t most) {
    const std::uint64_t target = next_step(), before = session_.run().step();
    if (before > target) return session_.stand_at(target);
    session_.advance(std::min(most, target - before));
    steps_ += std::max(session_.run().step(), before) - before;
}

/// "event 3 (pull) at step 120"
std::string Replay::place() const {
    if (next_ == recording_.events.size()) return fmt::format("the end at step {}", next_step());
    return fmt::format("event {} ({}) at step {}", next_ + 1, word_of(recording_.events[next_].event), next_step());
}

/// A run that diverged did so where it was found; it has to be found here, too.
std::optional<std::string> Replay::check_place() {
    if (next_diverged() && !session_.line().is_over()) session_.advance(2 * session_.run().check_interval());
    const std::uint64_t step = session_.run().step();
    if (session_.line().is_over() && (step != next_step() || !next_diverged()))
        return fmt::format("{}: the run diverged after step {}", place(), step);
    if (next_diverged() && !session_.line().is_over())
        return fmt::format("{}: the run diverged there when it was recorded, and does not now", place());
    return std::nullopt;
}

std::optional<std::string> Replay::compare(const std::string& recorded, const std::string& now, std::string_view of) {
    if (recorded.empty()) return std::nullopt;
    compared_ = true;
    if (recorded == now) return std::nullopt;
    return fmt::format("{}: the hash of {} is {}, but {} was recorded", place(), of, now, recorded);
}

std::optional<std::string> Replay::perform() {
    auto difference = check_place();
    if (!difference) difference = next_ < recording_.events.size() ? handle(recording_.events[next_]) : check_end();
    ++next_;
    return difference;
}

std::optional<std::string> Replay::handle(const RecordedEvent& entry) {
    const std::uint64_t before = session_.run().step();
    const std::string hash_before = is_seek(entry.event) ? session_.run().hash() : "";
    session_.stood_still(entry.pause);
    try {
        session_.handle(entry.event);
    } catch (const UsageError& refused) {
        return fmt::format("{}: it is refused: {}", place(), refused.what());
    }
    const bool took_steps = std::holds_alternative<event::Step>(entry.event);
    if (took_steps) steps_ += std::max(session_.run().step(), before) - before;
    return compare(entry.hash, is_seek(entry.event) ? hash_before : session_.run().hash(), "the leading run");
}

std::optional<std::string> Replay::check_end() {
    const std::vector<std::string>& hashes = recording_.end->hashes;
    if (hashes.empty()) return std::nullopt;
    if (auto difference = compare(hashes[0], session_.run().hash(), "the leading run")) return difference;
    if (hashes.size() == 1) return std::nullopt;
    session_.stand_at(next_step());  // the leading run may have been on its way
    try {
        session_.finish();
    } catch (const UsageError& refused) {
        return fmt::format("{}: a run cannot follow: {}", place(), refused.what());
    }
    const auto& followers = session_.followers();
    if (followers.size() + 1 != hashes.size())
        return fmt::format("{}: there are {} runs, but {} were recorded", place(), followers.size() + 1, hashes.size());
    for (std::size_t i = 0; i < followers.size(); ++i) {
        auto difference = compare(hashes[i + 1], followers[i].run().hash(), fmt::format("run {}", i + 1));
        if (difference) return difference;
    }
    return std::nullopt;
}

}  // namespace steplab
