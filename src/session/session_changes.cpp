// What is done to the leading run, taken back and done again.

#include "core/error.hpp"
#include "session/session.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <utility>

namespace steplab {

namespace {

/// Of the moments that they keep.
std::size_t bytes_of(const std::vector<TimeLine::Branch>& branches) {
    std::size_t sum = 0;
    for (const TimeLine::Branch& branch : branches) {
        for (const Moments::Moment& moment : branch.moments) sum += moment.state.bytes();
    }
    return sum;
}

}  // namespace

/// What the present way left is kept for coming back to.
void Session::keep(std::optional<TimeLine::Branch> left) {
    if (left) branches_.push_back(std::move(*left));
    if (branches_.size() > most_branches) branches_.erase(branches_.begin());
    for (TimeLine::Branch& oldest : branches_) {
        if (bytes_of(branches_) <= bytes_ / 2) break;
        oldest.moments = {};
    }
}

/// Something was done: what was undone before is no more to be done again.
void Session::note(Done before) {
    goal_.reset();
    undone_.clear();
    done_.push_back(std::move(before));
    forget_oldest_left();
}

/// What a change or an act of the time line leaves to be undone: nothing where it took the place of the one before it.
void Session::acted(std::size_t changes_before) {
    goal_.reset();
    undone_.clear();
    if (line_.past().size() > changes_before) note(Acted{});
}

/// With all that was done before it.
void Session::forget_oldest_left() {
    const auto is_left = [](const Done& done) { return std::holds_alternative<Left>(done); };
    if (std::count_if(done_.begin(), done_.end(), is_left) <= static_cast<std::ptrdiff_t>(most_left)) return;
    done_.erase(done_.begin(), std::next(std::find_if(done_.begin(), done_.end(), is_left)));
}

/// Puts another run in place of the leading one, which can be taken back; `beside` is what went beside it.
void Session::leave(TimeLine next, Beside beside) {
    Left left{std::exchange(line_, std::move(next)), std::exchange(branches_, {}), std::exchange(bookmarks_, {}),
              std::move(beside)};
    left.line.forget_moments();
    for (TimeLine::Branch& branch : left.branches) branch.moments = {};
    note(std::move(left));
}

/// With all its runs, unless the scene is another. While a slider is held the values that it goes through leave
/// nothing.
void Session::begin(const RunDescription& description, bool held) {
    TimeLine next(description, bytes_);
    std::vector<FollowerRun> followers;
    for (const FollowerRun& each : followers_) {
        if (auto beside_it = each.description_in(description, line_))
            followers.emplace_back(std::move(*beside_it), bytes_ / most_runs, each.swatch());
    }
    const bool goes_on =
        held && line_.changes().size() == 1 && !done_.empty() && std::holds_alternative<Left>(done_.back());
    if (goes_on) {
        goal_.reset();
        line_ = std::move(next);
    } else {
        leave(std::move(next), beside());
    }
    followers_ = std::move(followers);
    settle_swatch();
    begun();
}

/// What there was comes back as one when it is undone.
void Session::begin_alone(const RunDescription& description) {
    leave(TimeLine(description, bytes_), beside());
    followers_.clear();
    swatch_ = 0;
    equal_cost_ = false;
    ensemble_ = {};
    begun();
}

/// Another run is at its start.
void Session::begun() {
    ++number_;
    show_ensemble(ensemble_);
}

void Session::change(const event::Change& change) {
    const RunDescription& description = change.description;
    if (description == run().description()) return;
    if (restarts(run().description(), description)) return begin(description, change.held);
    std::vector<SegmentBegin> way(line_.past().begin(), line_.past().end());
    way.push_back({.step = line_.step(), .description = description});
    check_followers(way);
    if (plays_backwards()) stop();  // the run would go away from what is done
    const std::size_t before = line_.past().size();
    const bool was_last = done_.empty() || std::holds_alternative<Acted>(done_.back());
    keep(line_.change(description, was_last, change.held));
    acted(before);
    equalise_cost();
}

/// True if the last thing done is one of the time line, which has some behind the present step.
bool Session::can_undo_on_line() const {
    return line_.past().size() > 1 && (done_.empty() || std::holds_alternative<Acted>(done_.back()));
}

/// After the time line has gone another way by itself.
void Session::count_acted(std::size_t changes_before) {
    const auto acted_last = [&] { return !done_.empty() && std::holds_alternative<Acted>(done_.back()); };
    for (std::size_t i = changes_before; i < line_.past().size(); ++i) done_.emplace_back(Acted{});
    for (std::size_t i = line_.past().size(); i < changes_before && acted_last(); ++i) done_.pop_back();
}

bool Session::can_undo() const {
    const auto is_acted = [](const Done& done) { return std::holds_alternative<Acted>(done); };
    return line_.past().size() > 1 || !std::all_of(done_.begin(), done_.end(), is_acted);
}

void Session::undo() {
    goal_.reset();
    if (can_undo_on_line()) {
        const std::size_t before = line_.past().size();
        undone_.emplace_back(line_.undo().value());
        count_acted(before);
        return equalise_cost();
    }
    // what is done on the line lies ahead: the last of all else
    const auto last = std::find_if(done_.rbegin(), done_.rend(),
                                   [](const Done& done) { return !std::holds_alternative<Acted>(done); });
    if (last == done_.rend()) return;
    if (auto* const left = std::get_if<Left>(&*last)) {
        undone_.emplace_back(exchange(*left));
        done_.erase(std::prev(last.base()), done_.end());
    } else if (auto* const way = std::get_if<Way>(&*last)) {
        const Way back = std::move(*way);
        done_.erase(std::prev(last.base()));
        if (auto left_again = go_back_to(back)) undone_.emplace_back(std::move(*left_again));
    } else {
        undone_.emplace_back(exchange(std::get<Beside>(*last)));
        done_.erase(std::prev(last.base()));
    }
}

void Session::redo() {
    goal_.reset();
    if (undone_.empty()) return;
    Undone& last = undone_.back();
    if (auto* const branch = std::get_if<TimeLine::Branch>(&last)) {
        check_followers(branch->changes);
        const std::size_t before = line_.past().size();
        line_.take(std::move(*branch));
        count_acted(before);
        equalise_cost();
    } else if (auto* const left = std::get_if<Left>(&last)) {
        done_.emplace_back(exchange(*left));
    } else if (const auto* const way = std::get_if<Way>(&last)) {
        if (auto left_for_it = go_back_to(*way)) done_.emplace_back(std::move(*left_for_it));
    } else {
        done_.emplace_back(exchange(std::get<Beside>(last)));
    }
    undone_.pop_back();
}

/// Puts another line in place of the present one, which is returned.
Session::Left Session::exchange(Left& other) {
    std::vector<FollowerRun> followers = made(other.beside);
    Left now{std::exchange(line_, std::move(other.line)), std::exchange(branches_, std::move(other.branches)),
             std::exchange(bookmarks_, std::move(other.bookmarks)), beside()};
    followers_ = std::move(followers);
    swatch_ = other.beside.swatch;
    equal_cost_ = other.beside.equal_cost;
    begun();
    return now;
}

/// The same of what goes beside it. Runs that are there already stay as they are.
Session::Beside Session::exchange(const Beside& wanted) {
    std::vector<FollowerRun> followers = made(wanted);
    Beside now = beside();
    for (FollowerRun& next : followers) {
        const auto same = std::find_if(followers_.begin(), followers_.end(), [&](const FollowerRun& each) {
            return each.description() == next.description() && each.swatch() == next.swatch();
        });
        if (same == followers_.end()) continue;
        next = std::move(*same);
        followers_.erase(same);
    }
    followers_ = std::move(followers);
    swatch_ = wanted.swatch;
    equal_cost_ = wanted.equal_cost;
    return now;
}

void Session::take_branch(std::size_t number) {
    if (number >= branches_.size()) throw UsageError(fmt::format("there is no branch {}", number));
    check_followers(branches_[number].changes);
    if (auto left = go_over_to(number)) {
        note(std::move(*left));
    } else {
        goal_.reset();
        undone_.clear();
    }
}

/// What is left, if there is something of it beyond where the two part.
std::optional<Session::Way> Session::go_over_to(std::size_t number) {
    TimeLine::Branch branch = std::move(branches_[number]);
    branches_.erase(branches_.begin() + static_cast<std::ptrdiff_t>(number));
    const std::size_t before = line_.past().size();
    std::optional<TimeLine::Branch> left = line_.take(std::move(branch));
    std::optional<Way> way;
    if (left) way = Way{left->changes};
    keep(std::move(left));
    count_acted(before);
    equalise_cost();
    return way;
}

/// None, and nothing happens, if it was forgotten meanwhile.
std::optional<Session::Way> Session::go_back_to(const Way& way) {
    const auto found = std::find_if(branches_.rbegin(), branches_.rend(),
                                    [&](const TimeLine::Branch& branch) { return branch.changes == way.changes; });
    if (found == branches_.rend()) return std::nullopt;
    check_followers(way.changes);
    return go_over_to(static_cast<std::size_t>(std::prev(found.base()) - branches_.begin()));
}

}  // namespace steplab
