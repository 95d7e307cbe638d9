#include "session/session.hpp"

#include "core/error.hpp"
#include "session/marks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace steplab {

namespace {

constexpr auto never = [] { return false; };

}  // namespace

Session::Session(const RunDescription& description, std::size_t bytes) : bytes_(bytes), line_(description, bytes) {}

/// One function for each kind of event.
struct Session::Handle {
    Session& session;

    void operator()(const event::Play& play) const { session.play(play); }
    void operator()(const event::Loop& loop) const { session.loop(loop); }
    void operator()(const event::Step& step) const { session.step(step.steps); }
    void operator()(const event::Seek& seek) const { session.seek(seek.step); }
    void operator()(const event::SeekTime& seek) const { session.seek(session.line_.step_at(seek.time)); }
    void operator()(const event::Restart&) const { session.begin(session.run().description()); }
    void operator()(const event::Begin& begin) const { session.begin_alone(begin.description); }
    void operator()(const event::Change& change) const { session.change(change); }
    void operator()(const event::SetRate& rate) const { session.rate_ = rate.rate; }
    void operator()(const event::Track& track) const { session.tracked_ = track.particle; }
    void operator()(const event::AlsoTrack& track) const { session.also_tracked_ = track.particles; }
    void operator()(const event::Do& act) const { session.act(act.act); }
    void operator()(const event::Undo&) const { session.undo(); }
    void operator()(const event::Redo&) const { session.redo(); }
    void operator()(const event::ShowEnsemble& show) const { session.show_ensemble(show.ensemble); }
    void operator()(const event::ShowForces& show) const { session.with_forces_ = show.on; }
    void operator()(const event::Magnify& magnify) const { session.magnified_ = magnify.factor; }
    void operator()(const event::ShowErrors& show) const { session.with_errors_ = show.on; }
    void operator()(const event::ShowSamples& show) const { session.with_samples_ = show.on; }
    void operator()(const event::ShowCosts& show) const { session.with_costs_ = show.on; }
    void operator()(const event::AddRun& added) const { session.add(added); }
    void operator()(const event::ChangeRun& change) const { session.change_run(change.run, change.description); }
    void operator()(const event::EqualCost& cost) const { session.set_equal_cost(cost.on); }
    void operator()(const event::RemoveRun& remove) const { session.remove(remove.run); }
    void operator()(const event::Lead& lead) const { session.lead(session.check_follower(lead.run)); }
    void operator()(const event::Bookmark& mark) const { session.bookmark(mark.text); }
    void operator()(const event::TakeBranch& take) const { session.take_branch(take.branch); }
};

void Session::handle(const Event& event) {
    const TrackedParticles before = tracked();
    recording_&& is_recorded(event) ? handle_and_record(event) : std::visit(Handle{*this}, event);
    line_.sample(with_samples_, tracked());  // also of a run that began
    for (FollowerRun& each : followers_) each.line().sample_as(line_);
    sample_spread();
    if (!is_any<event::AlsoTrack>(event) || tracked() != before) look_for_lacking(event);
}

/// After what can have changed which samples are lacking.
void Session::look_for_lacking(const Event& event) {
    if (is_any<event::Play, event::Loop, event::Step, event::Seek, event::SeekTime, event::SetRate, event::Bookmark,
               event::ShowEnsemble, event::ShowForces, event::Magnify, event::ShowErrors, event::ShowCosts>(event))
        return;
    for (FollowerRun& each : followers_) each.forget_other_samples(line_);
    late_ = {};
    lacking_ = with_samples_;
}

bool Session::complete_samples(const std::function<bool()>& enough) {
    if (!lacking_) return false;
    try {
        lacking_ = !late_.take(line_, followers_, enough);
        return late_.found();
    } catch (const std::exception& problem) {
        lacking_ = false;
        if (!dynamic_cast<const UsageError*>(&problem)) throw;
        return false;  // it is told when the run itself comes there
    }
}

/// What is refused changes nothing and is not recorded.
void Session::handle_and_record(const Event& event) {
    RecordedEvent entry{event, line_.step(), line_.is_over(), "", std::exchange(stood_, 0)};
    const bool computes = changes_runs(event);
    const bool nothing_new = !playing_ && line_.reached() == known_;
    if (is_seek(event)) entry.hash = event_hash();
    std::visit(Handle{*this}, event);
    if (computes && !is_seek(event)) entry.hash = event_hash();
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

void Session::advance(std::uint64_t steps) {
    take_forward(steps);
    if (line_.is_over()) {
        const bool goes_on = plays_backwards();
        stop();
        playing_ = goes_on;
    }
    if (!goal_ || line_.step() < *goal_) return;
    goal_.reset();
    line_.find_end();
}

void Session::play(const event::Play& play) {
    playing_ = play.on && (play.backwards ? line_.step() > 0 : !line_.is_over() || loop_);
    backwards_ = play.backwards;
    goal_.reset();
}

void Session::loop(const event::Loop& loop) {
    check(loop);
    loop_ = loop.steps;
}

std::uint64_t Session::play_on(std::uint64_t steps) {
    const std::uint64_t before = line_.step();
    const bool on_its_way = goal_.has_value();
    if (backwards_ && !on_its_way) {
        line_.step_back(std::min(steps, before - first_played()));
    } else {
        const bool in_loop = loop_ && !on_its_way && before < loop_->last;
        advance(in_loop ? std::min(steps, loop_->last - before) : steps);
    }
    const std::uint64_t now = line_.step();
    if (!on_its_way) turn_at_end();
    return now > before ? now - before : before - now;
}

/// Where playing backwards ends.
std::uint64_t Session::first_played() const { return loop_ && line_.step() > loop_->first ? loop_->first : 0; }

/// At the end of its way: to the other end of its loop, if it plays one.
void Session::turn_at_end() {
    if (backwards_ && line_.step() > first_played() && !(loop_ && line_.step() == loop_->first)) return;
    if (!backwards_ && (!loop_ || (line_.step() < loop_->last && !line_.is_over()))) return;
    if (!loop_) return stop();
    playing_ = true;  // also where the run ended before the loop does
    const event::Seek turn{backwards_ ? loop_->last : loop_->first};
    // how far the run had got matters to what is done later: branches
    line_.reached() > known_ ? handle(turn) : seek(turn.step);
}

bool Session::is_behind() const {
    if (live_ensemble_ && !ensemble_is_beside()) return true;
    return std::any_of(followers_.begin(), followers_.end(),
                       [&](const FollowerRun& follower) { return !follower.is_beside(line_); });
}

bool Session::wants_errors() const {
    if (!followers_.empty()) return true;
    return with_errors_.value_or(!run().why_not_exact().empty() && run().particles() <= most_compared_alone);
}

void Session::catch_up(const std::function<bool()>& enough) {
    for (auto follower = followers_.begin(); follower != followers_.end(); ++follower) {
        try {
            if (!follower->follow(line_, enough)) return;
        } catch (const UsageError&) {
            followers_.erase(follower);
            late_ = {};
            settle_swatch();
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
    sample_spread();
}

bool Session::ensemble_is_beside() const {
    return live_ensemble_ && live_ensemble_->are_at(line_.step(), line_.past());
}

/// Of the ensemble where it stands, if samples are taken; those of what was done otherwise are forgotten.
void Session::sample_spread() {
    if (!with_samples_ || !live_ensemble_) return spread_.reset();
    if (!spread_) spread_.emplace(ensemble_.runs * run().particles());
    spread_->follow(tracked_);
    spread_->follow(line_.changes());
    if (ensemble_is_beside()) spread_->offer(run(), *live_ensemble_);
}

/// An ensemble that is sampled goes along from sample to sample, beginning beside the run.
void Session::take_forward(std::uint64_t steps) {
    const std::uint64_t target = run().advanced().step + steps;
    if (spread_ && !ensemble_is_beside()) catch_up(never);
    while (spread_ && run().advanced().step < target && !line_.is_over()) {
        const std::uint64_t step = run().advanced().step;
        line_.advance(std::min(target - step, spread_->to_next(step)));
        catch_up(never);
    }
    line_.advance(target - std::min(target, run().advanced().step));
}

void Session::stop() {
    playing_ = false;
    goal_.reset();
}

/// At once: what comes next is done at the step reached.
void Session::step(std::int64_t steps) {
    playing_ = false;
    goal_.reset();
    if (steps < 0) {
        line_.step_back(std::uint64_t{0} - static_cast<std::uint64_t>(steps));
    } else {
        take_forward(static_cast<std::uint64_t>(steps));
    }
}

void Session::finish() {
    if (goal_) advance(*goal_ - std::min(*goal_, line_.step()));
    while (is_behind()) catch_up(never);
}

void Session::seek(std::uint64_t step) {
    goal_.reset();
    if (step == line_.step()) return;
    lacking_ = with_samples_;  // runs beside the leading one may have less of the way ahead
    line_.turn_to(step);
    line_.advance(0);  // what was done at the step reached
    if (line_.step() != step) {
        goal_ = step;
    } else {
        line_.find_end();
    }
}

void Session::bookmark(const std::string& text) { toggle_mark(bookmarks_, {line_.step(), line_.time(), text}); }

/// The ensemble begins where the run began.
void Session::show_ensemble(const LiveEnsembleOptions& asked) {
    ensemble_ = asked;
    live_ensemble_.reset();
    spread_.reset();
    if (ensemble_.runs == 0) return;
    live_ensemble_.emplace(ensemble_.runs, [of = ensemble_](const RunDescription& description, std::size_t member) {
        return run_in_range(description, ranges_of(of, description), member, of.runs);
    });
}

}  // namespace steplab
