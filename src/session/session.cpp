#include "session/session.hpp"

#include "core/error.hpp"
#include "session/equal_cost.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <utility>

namespace steplab {

namespace {

constexpr auto never = [] { return false; };

/// Of the moments that they keep.
std::size_t bytes_of(const std::vector<TimeLine::Branch>& branches) {
    std::size_t sum = 0;
    for (const TimeLine::Branch& branch : branches) {
        for (const Moments::Moment& moment : branch.moments) sum += moment.state.bytes();
    }
    return sum;
}

}  // namespace

Session::Session(const RunDescription& description, std::size_t bytes) : bytes_(bytes), line_(description, bytes) {}

/// One function for each kind of event.
struct Session::Handle {
    Session& session;

    void operator()(const event::Play& play) const {
        session.playing_ = play.on && !session.line_.is_over();
        session.goal_.reset();
    }
    void operator()(const event::Step& step) const { session.step(step.steps); }
    void operator()(const event::Seek& seek) const { session.seek(seek.step); }
    void operator()(const event::SeekTime& seek) const { session.seek(session.line_.step_at(seek.time)); }
    void operator()(const event::Restart&) const { session.begin(session.run().description()); }
    void operator()(const event::Change& change) const { session.change(change.description); }
    void operator()(const event::SetRate& rate) const { session.rate_ = rate.rate; }
    void operator()(const event::Track& track) const { session.tracked_ = track.particle; }
    void operator()(const event::Do& act) const { session.act(act.act); }
    void operator()(const event::Undo&) const { session.undo(); }
    void operator()(const event::Redo&) const { session.redo(); }
    void operator()(const event::ShowEnsemble& show) const { session.show_ensemble(show.ensemble); }
    void operator()(const event::ShowForces& show) const { session.with_forces_ = show.on; }
    void operator()(const event::ShowErrors& show) const { session.with_errors_ = show.on; }
    void operator()(const event::AddRun& add) const {
        if (session.followers_.size() + 1 == most_runs)
            throw UsageError(fmt::format("at most {} runs go beside each other", most_runs));
        session.followers_.push_back(session.follower(session.at_cost(add.description)));
    }
    void operator()(const event::ChangeRun& change) const {
        session.followers_.at(session.check_follower(change.run)) =
            session.follower(session.at_cost(change.description));
    }
    void operator()(const event::EqualCost& cost) const {
        session.equal_cost_ = cost.on;
        session.equalise_cost();
    }
    void operator()(const event::RemoveRun& remove) const { session.remove(remove.run); }
    void operator()(const event::Lead& lead) const { session.lead(session.check_follower(lead.run)); }
    void operator()(const event::Bookmark& mark) const { session.bookmark(mark.text); }
    void operator()(const event::TakeBranch& take) const { session.take_branch(take.branch); }
};

void Session::handle(const Event& event) {
    if (recording_ && is_recorded(event)) return handle_and_record(event);
    std::visit(Handle{*this}, event);
}

/// What is refused changes nothing and is not recorded.
void Session::handle_and_record(const Event& event) {
    RecordedEvent entry{event, line_.step(), line_.is_over()};
    const bool nothing_new = !playing_ && line_.reached() == known_;
    if (is_seek(event)) entry.hash = event_hash();
    std::visit(Handle{*this}, event);
    if (!is_seek(event)) entry.hash = event_hash();
    known_ = line_.reached();
    recording_->add(std::move(entry), nothing_new);
}

std::string Session::event_hash() const { return run().particles() <= most_hashed_ ? run().hash() : ""; }

void Session::record(std::size_t most_hashed) {
    recording_ = Recording{.start = line_.changes().front().description};
    most_hashed_ = most_hashed;
    known_ = line_.reached();
}

std::optional<Recording> Session::recorded(bool with_end) const {
    if (!recording_) return std::nullopt;
    Recording recording = *recording_;
    if (!recording.complete || !with_end) return recording;
    RecordedEnd end{line_.step(), line_.is_over(), {run().hash()}};
    const bool together = std::all_of(followers_.begin(), followers_.end(),
                                      [&](const FollowerRun& follower) { return follower.is_beside(line_); });
    for (std::size_t i = 0; together && i < followers_.size(); ++i) end.hashes.push_back(followers_[i].run().hash());
    recording.end = std::move(end);
    return recording;
}

void Session::stand_at(std::uint64_t step) {
    goal_.reset();
    line_.turn_to(step);
    line_.advance(step - std::min(step, line_.step()));
}

/// The place of a run that does not lead. Throws UsageError.
std::size_t Session::check_follower(std::size_t run) const {
    if (run == 0 || run > followers_.size()) throw UsageError(fmt::format("there is no run {} beside the first", run));
    return run - 1;
}

FollowerRun Session::follower(const RunDescription& description) const {
    if (description.model != run().description().model || description.origin != run().description().origin)
        throw UsageError("runs beside each other are of one scene");
    FollowerRun added(FollowerRun::at_start(description, line_), bytes_ / most_runs);
    if (added.run().particles() != run().particles())
        throw UsageError("runs beside each other have the same particles");
    return added;
}

void Session::advance(std::uint64_t steps) {
    line_.advance(steps);
    if (line_.is_over()) stop();
    if (goal_ && line_.step() >= *goal_) goal_.reset();
}

bool Session::is_behind() const {
    if (live_ensemble_ && !live_ensemble_->are_at(line_.step(), line_.past())) return true;
    return std::any_of(followers_.begin(), followers_.end(),
                       [&](const FollowerRun& follower) { return !follower.is_beside(line_); });
}

bool Session::wants_errors() const {
    if (!followers_.empty()) return true;
    return with_errors_.value_or(!run().has_exact() && run().particles() <= most_compared_alone);
}

void Session::catch_up(const std::function<bool()>& enough) {
    for (auto follower = followers_.begin(); follower != followers_.end(); ++follower) {
        try {
            if (!follower->follow(line_, enough)) return;
        } catch (const UsageError&) {
            followers_.erase(follower);
            throw;
        }
    }
    if (!live_ensemble_) return;
    try {
        live_ensemble_->go_to(line_.step(), line_.past(), enough);
    } catch (const UsageError&) {
        show_ensemble({});
        throw;
    }
}

void Session::stop() {
    playing_ = false;
    goal_.reset();
}

/// At once: what comes next is done at the step reached.
void Session::step(std::int64_t steps) {
    playing_ = false;
    goal_.reset();
    const std::uint64_t now = line_.step();
    const auto size = static_cast<std::uint64_t>(steps < 0 ? -steps : steps);
    const std::uint64_t target = steps < 0 ? now - std::min(now, size) : now + size;
    line_.turn_to(target);
    line_.advance(target - line_.step());
}

void Session::finish() {
    if (goal_) advance(*goal_ - std::min(*goal_, line_.step()));
    while (is_behind()) catch_up(never);
}

void Session::seek(std::uint64_t step) {
    goal_.reset();
    if (step == line_.step()) return;
    line_.turn_to(step);
    line_.advance(0);  // what was done at the step reached
    if (line_.step() != step) goal_ = step;
}

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
void Session::changed() {
    goal_.reset();
    undone_.clear();
}

void Session::begin(const RunDescription& description) {
    TimeLine next(description, bytes_);
    std::vector<FollowerRun> followers;
    const bool same_scene = !restarts(run().description(), description);
    if (same_scene) {
        for (const FollowerRun& each : followers_)
            followers.push_back(FollowerRun(each.description_at(line_), bytes_ / most_runs));
    }
    changed();
    left_.push_back(
        {std::exchange(line_, std::move(next)), std::exchange(branches_, {}), std::exchange(bookmarks_, {})});
    left_.back().line.forget_moments();
    for (TimeLine::Branch& branch : left_.back().branches) branch.moments = {};
    if (left_.size() > most_left) left_.erase(left_.begin());
    followers_ = std::move(followers);
    begun();
}

/// Another run is at its start.
void Session::begun() {
    ++number_;
    show_ensemble(ensemble_);
}

void Session::change(const RunDescription& description) {
    if (description == run().description()) return;
    if (restarts(run().description(), description)) return begin(description);
    keep(line_.change(description));
    changed();
    equalise_cost();
}

/// As it is to run beside the leading one.
RunDescription Session::at_cost(const RunDescription& description) const {
    return equal_cost_ ? at_equal_cost(description, run().description()) : description;
}

/// Those whose cost changes begin again; one that cannot have it stays as it is, as the event is carried out already.
void Session::equalise_cost() {
    if (!equal_cost_) return;
    for (FollowerRun& each : followers_) {
        try {
            const RunDescription wanted = at_cost(each.description());
            if (!(wanted == each.description())) each = follower(wanted);
        } catch (const UsageError&) {
            continue;
        }
    }
}

void Session::undo() {
    goal_.reset();
    if (auto branch = line_.undo()) {
        undone_.emplace_back(std::move(*branch));
    } else if (!left_.empty()) {
        Left before = std::move(left_.back());
        left_.pop_back();
        undone_.emplace_back(exchange(std::move(before)));
    }
}

void Session::redo() {
    goal_.reset();
    if (undone_.empty()) return;
    Undone last = std::move(undone_.back());
    undone_.pop_back();
    if (auto* const branch = std::get_if<TimeLine::Branch>(&last)) {
        line_.take(std::move(*branch));
    } else {
        left_.push_back(exchange(std::move(std::get<Left>(last))));
    }
}

/// Puts another line in place of the present one, which is returned.
Session::Left Session::exchange(Left other) {
    Left now{std::exchange(line_, std::move(other.line)), std::exchange(branches_, std::move(other.branches)),
             std::exchange(bookmarks_, std::move(other.bookmarks))};
    const bool same_scene = !restarts(now.line.run().description(), run().description());
    if (!same_scene) followers_.clear();
    begun();
    return now;
}

void Session::take_branch(std::size_t number) {
    if (number >= branches_.size()) throw UsageError(fmt::format("there is no branch {}", number));
    TimeLine::Branch branch = std::move(branches_[number]);
    branches_.erase(branches_.begin() + static_cast<std::ptrdiff_t>(number));
    changed();
    keep(line_.take(std::move(branch)));
}

void Session::bookmark(const std::string& text) {
    const auto here =
        std::find_if(bookmarks_.begin(), bookmarks_.end(), [&](const Mark& mark) { return mark.step == line_.step(); });
    if (here != bookmarks_.end()) {
        bookmarks_.erase(here);
        return;
    }
    bookmarks_.push_back({line_.step(), line_.time(), text});
    std::sort(bookmarks_.begin(), bookmarks_.end(), [](const Mark& a, const Mark& b) { return a.step < b.step; });
}

/// Both are at one time. The run that led begins again beside the other; steps of branches and marks were its steps.
void Session::lead(std::size_t number) {
    catch_up(never);
    const RunDescription led = run().description();
    FollowerRun& next = followers_[number];
    line_ = std::move(next.line());
    line_.forget_ahead();  // how far it had gone there depends on when it was made to follow
    next = follower(led);
    branches_.clear();
    bookmarks_.clear();
    left_.clear();
    changed();
    begun();
}

void Session::remove(std::size_t run) {
    if (run == 0) {
        if (followers_.empty()) throw UsageError("the only run cannot be removed");
        lead(0);
        run = 1;
    }
    followers_.erase(followers_.begin() + static_cast<std::ptrdiff_t>(check_follower(run)));
}

/// The ensemble begins where the run began.
void Session::show_ensemble(const LiveEnsembleOptions& asked) {
    ensemble_ = asked;
    live_ensemble_.reset();
    if (ensemble_.runs == 0) return;
    live_ensemble_.emplace(ensemble_.runs, [of = ensemble_](const RunDescription& description, std::size_t member) {
        return run_in_range(description, ranges_of(of, description), member, of.runs);
    });
}

}  // namespace steplab
