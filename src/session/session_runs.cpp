// What goes beside the leading run, and which one leads.

#include "core/error.hpp"
#include "session/equal_cost.hpp"
#include "session/session.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <utility>

namespace steplab {

/// The place of a run that does not lead. Throws UsageError.
std::size_t Session::check_follower(std::size_t run) const {
    if (run == 0 || run > followers_.size()) throw UsageError(fmt::format("there is no run {} beside the first", run));
    return run - 1;
}

FollowerRun Session::follower(const RunDescription& description, std::size_t swatch) const {
    if (description.model != run().description().model || description.origin != run().description().origin)
        throw UsageError("runs beside each other are of one scene");
    FollowerRun added(description, bytes_ / most_runs, swatch);
    if (added.run().particles() != run().particles())
        throw UsageError("runs beside each other have the same particles");
    added.check_way(line_.changes());
    return added;
}

/// A run that could not go that way would be lost on it. Throws UsageError.
void Session::check_followers(std::span<const SegmentBegin> way) const {
    for (const FollowerRun& each : followers_) {
        try {
            each.check_way(way);
        } catch (const UsageError& error) {
            throw UsageError(fmt::format("{}; remove it first", error.what()));
        }
    }
}

Session::Beside Session::beside() const {
    Beside now{{}, swatch_, equal_cost_};
    for (const FollowerRun& each : followers_) now.runs.push_back({each.description(), each.swatch()});
    return now;
}

/// Such runs at their start.
std::vector<FollowerRun> Session::made(const Beside& wanted) const {
    std::vector<FollowerRun> runs;
    for (const auto& [description, swatch] : wanted.runs) runs.emplace_back(description, bytes_ / most_runs, swatch);
    return runs;
}

/// The first that no run has.
std::size_t Session::free_swatch() const {
    std::size_t swatch = 0;
    const auto has_it = [&](const FollowerRun& each) { return each.swatch() == swatch; };
    while (swatch == swatch_ || std::any_of(followers_.begin(), followers_.end(), has_it)) ++swatch;
    return swatch;
}

/// Alone there is nothing to tell a run from.
void Session::settle_swatch() {
    if (followers_.empty()) swatch_ = 0;
}

void Session::add(const event::AddRun& wanted) {
    if (followers_.size() + 1 == most_runs)
        throw UsageError(fmt::format("at most {} runs go beside each other", most_runs));
    FollowerRun added = follower(at_cost(FollowerRun::at_start(wanted.description, line_)), free_swatch());
    if (!wanted.opening) note(beside());
    followers_.push_back(std::move(added));
}

void Session::change_run(std::size_t run, const RunDescription& description) {
    FollowerRun& changed = followers_[check_follower(run)];
    FollowerRun next = follower(at_cost(FollowerRun::at_start(description, line_)), changed.swatch());
    note(beside());
    changed = std::move(next);
}

void Session::set_equal_cost(bool on) {
    if (on == equal_cost_) return;
    note(beside());
    equal_cost_ = on;
    equalise_cost();
}

/// As it is to run beside the leading one.
RunDescription Session::at_cost(const RunDescription& description) const {
    return equal_cost_ ? at_equal_cost(description, run().description()) : description;
}

/// Those whose cost changes begin again; one that cannot have it stays as it is, as the event is carried out already.
void Session::equalise_cost() {
    not_equal_.clear();
    if (!equal_cost_) return;
    for (FollowerRun& each : followers_) {
        try {
            const RunDescription wanted = at_cost(each.description());
            if (!(wanted == each.description())) each = follower(wanted, each.swatch());
        } catch (const UsageError& error) {
            not_equal_ = error.what();
        }
    }
}

/// Both are at one time. The run that led begins again beside the other, with its present method and dt.
void Session::lead(std::size_t number) {
    catch_up([] { return false; });
    Beside before = beside();
    RunDescription led = run().description();
    led.scene = line_.changes().front().description.scene;
    led.alterations = line_.changes().front().description.alterations;
    FollowerRun beside_it = follower(led, swatch_);
    const std::size_t swatch = followers_[number].swatch();
    TimeLine next = std::move(followers_[number].line());
    next.forget_ahead();  // how far it had gone there depends on when it was made to follow
    next.allow(bytes_);
    leave(std::move(next), std::move(before));
    followers_[number] = std::move(beside_it);
    swatch_ = swatch;
    begun();
}

void Session::remove(std::size_t run) {
    if (run > 0) {
        const std::size_t place = check_follower(run);
        note(beside());
        followers_.erase(followers_.begin() + static_cast<std::ptrdiff_t>(place));
    } else {
        if (followers_.empty()) throw UsageError("the only run cannot be removed");
        lead(0);
        followers_.erase(followers_.begin());
    }
    not_equal_.clear();
    settle_swatch();
}

}  // namespace steplab
