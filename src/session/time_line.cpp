#include "session/time_line.hpp"

#include "core/error.hpp"
#include "session/change_text.hpp"
#include "session/compared.hpp"
#include "session/same_way.hpp"
#include "session/tug.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

namespace steplab {

namespace {

/// Of so many steps at once, moments are kept at the ends of its parts.
constexpr std::uint64_t long_way = 4096, parts_of_long_way = 64;
/// Measured costs older than this fade.
constexpr double remembered_seconds = 0.25;
/// Steps that are computed again rather than kept.
constexpr std::uint64_t nearby = 8;

/// Steps of dt from the beginning of a segment on that do not end after a time.
std::uint64_t steps_within(double time, const RunDescription& description) {
    return steplab::step_at(time, rounded_to(description.precision, description.dt));
}

}  // namespace

TimeLine::TimeLine(const RunDescription& description, std::size_t bytes)
    : run_(description), moments_(bytes), changes_{{0, description}}, start_momentum_(run_.diagnostics().momentum) {
    keep_moment();
}

void TimeLine::advance(std::uint64_t steps) {
    const std::uint64_t target = run_.advanced().step + steps;
    if (!run_.advanced().diverged) asked_ = target;
    const std::uint64_t stretch = steps < long_way ? steps : steps / parts_of_long_way;
    take_due_changes();
    while (run_.advanced().step < target && !run_.advanced().diverged) {
        std::uint64_t next = std::min(target, run_.advanced().step + stretch);
        if (taken_ < changes_.size()) next = std::min(next, changes_[taken_].step);
        take_steps(next - run_.advanced().step);
        take_due_changes();
        if (steps >= long_way) keep_moment();
    }
    note_reached();
}

/// Samples are no part of what the steps cost.
void TimeLine::take_steps(std::uint64_t steps) {
    using Clock = std::chrono::steady_clock;
    const std::uint64_t before = run_.advanced().step, target = before + steps;
    double spent = 0;
    while (run_.advanced().step < target && !run_.advanced().diverged) {
        const std::uint64_t step = run_.advanced().step, left = target - step;
        const auto begin = Clock::now();
        run_.advance(samples_ ? std::min(left, samples_->to_next(step)) : left);
        spent += std::chrono::duration<double>(Clock::now() - begin).count();
        if (samples_) samples_->offer(run_);
    }
    const double fading = std::exp(-spent / remembered_seconds),
                 taken = static_cast<double>(run_.advanced().step) - static_cast<double>(before);
    spent_ = spent_ * fading + spent;
    simulated_ = simulated_ * fading + taken * std::abs(run_.dt());
}

void TimeLine::sample(bool on, TrackedParticles particles) {
    if (!on) return samples_.reset();
    std::erase_if(particles, [this](std::size_t particle) { return particle >= run_.particles(); });
    if (samples_ && samples_->followed() == particles && run_.step() > 0) return;  // the start may have become another
    if (!samples_) samples_.emplace(run_.particles());
    samples_->follow(particles);
    const bool changed_here = taken_ > 1 && changes_[taken_ - 1].step == run_.step();
    if (!changed_here || run_.step() == 0) samples_->offer(run_);  // samples are of before a change
}

void TimeLine::sample_as(const TimeLine& other) {
    sample(other.samples_.has_value(), other.samples_ ? other.samples_->followed() : TrackedParticles());
}

void TimeLine::take_samples(const TimeLine& same) {
    if (samples_ && same.samples_) samples_->take(*same.samples_, reached_);
}

void TimeLine::forget_samples_behind(std::uint64_t step) {
    if (samples_) samples_->cut(step);
}

TimeLine TimeLine::again(std::size_t bytes) const {
    TimeLine line(changes_.front().description, bytes);
    line.take({.changes = changes_, .moments = {}, .reached = reached_, .reached_time = reached_time_});
    line.sample_as(*this);
    return line;
}

void TimeLine::put_samples_into(SampleSeries& series) const {
    samples_ ? samples_->put_into(series) : void(series = {});
}

std::optional<double> TimeLine::cost() const {
    return simulated_ > 0 ? std::optional(spent_ / simulated_) : std::nullopt;
}

/// In halves: what is between two moments is computed again once for each of its halvings, however it is gone through.
void TimeLine::step_back(std::uint64_t steps) {
    settle();
    const std::uint64_t target = run_.step() - std::min(run_.step(), steps);
    turn_to(target);
    while (target - run_.step() > nearby && !run_.advanced().diverged) {
        advance((target - run_.step()) / 2);
        moments_.keep(run_, taken_, first_of_last(past()));
    }
    advance(target - run_.step());
}

void TimeLine::keep_moment() { moments_.offer(run_, taken_, first_of_last(past())); }

/// Behind the last good step of a run that diverged lies nothing, however far it had got before that was found.
void TimeLine::note_reached() {
    const auto [step, evaluations, over] = run_.advanced();
    if (step <= reached_ && !over) return;
    if (over) moments_.cut(step, taken_);
    if (over && samples_) samples_->cut(step);
    reached_ = step;
    reached_time_ = time_of(step);
    ended_ = over;
}

void TimeLine::find_end() {
    if (!ended_ || is_over() || run_.step() != reached_ || taken_ != changes_.size()) return;
    run_.advance(1);
    run_.conclude();
    note_reached();
}

/// Those of the present step; of a run that has diverged, what was done where it stands, from which it goes on. What is
/// done at step 0 belongs to the start that samples tell of.
void TimeLine::take_due_changes() {
    const std::size_t before = taken_;
    while (taken_ < changes_.size() && changes_[taken_].step == run_.advanced().step) {
        take_effect(changes_[taken_]);
        ++taken_;
        keep_moment();
    }
    if (samples_ && taken_ > before && run_.advanced().step == 0) samples_->take_again(run_);
}

void TimeLine::take_effect(SegmentBegin& change) {
    change.time = run_.time();
    if (!change.act) spent_ = simulated_ = 0;
    if (change.act) {
        run_.act(*change.act);
    } else {
        run_.change(change.description);
    }
}

/// What is found when the numbers of a step are read.
void TimeLine::settle() {
    if (is_over()) note_reached();
}

void TimeLine::turn_to(std::uint64_t step) {
    settle();
    turn_to(step, run_.step() <= step);
}

void TimeLine::turn_to_any(std::uint64_t step) {
    settle();
    turn_to(step, run_.step() <= step && !ended_beyond(step));
}

void TimeLine::turn_to(std::uint64_t step, bool can_go_on) {
    const auto due = static_cast<std::size_t>(std::count_if(
        changes_.begin(), changes_.end(), [&](const SegmentBegin& change) { return change.step <= step; }));
    const Moments::Moment* const nearest = moments_.before(step, due);
    if (can_go_on && (!nearest || nearest->step <= run_.step())) return;
    go_back_to(nearest);
    asked_ = run_.step();
}

std::vector<ReplayedRun::Moment> TimeLine::kept_moments() const {
    std::vector<ReplayedRun::Moment> kept;
    for (const Moments::Moment& moment : moments_.all()) {
        if (moment.step <= run_.step() && moment.changes <= taken_) kept.push_back({moment.state, moment.changes});
    }
    return kept;
}

/// A moment that was kept; null: the start.
void TimeLine::go_back_to(const Moments::Moment* moment) {
    if (moment) {
        run_.restore(moment->state);
        taken_ = moment->changes;
    } else {
        run_.begin(changes_.front().description);
        taken_ = 1;
    }
}

std::uint64_t TimeLine::step_at(double time) const {
    const auto next = std::find_if(std::next(changes_.begin()), changes_.end(),
                                   [&](const SegmentBegin& change) { return change.time > time; });
    const SegmentBegin& segment = *std::prev(next);
    return segment.step + steps_within(time - segment.time, segment.description);
}

double TimeLine::time_of(std::uint64_t step) const {
    const auto next = std::find_if(std::next(changes_.begin()), changes_.end(),
                                   [&](const SegmentBegin& change) { return change.step > step; });
    const SegmentBegin& segment = *std::prev(next);
    const RunDescription& run = segment.description;
    return segment.time + static_cast<double>(step - segment.step) * rounded_to(run.precision, run.dt);
}

std::optional<TimeLine::Branch> TimeLine::change(const RunDescription& description, bool may_replace, bool held) {
    if (description == run_.description()) return std::nullopt;
    if (restarts(run_.description(), description)) throw UsageError("this change begins another run");
    check(description);
    return append({.step = run_.step(), .description = description, .held = held && taken_ > 1}, may_replace);
}

std::optional<TimeLine::Branch> TimeLine::act(const Act& act) { return append({run_.step(), run_.description(), act}); }

/// A slider that is dragged while the run stands leaves one change, and so does a particle.
bool TimeLine::replaces_last(const SegmentBegin& change) const {
    if (taken_ == 1) return false;
    const SegmentBegin &last = changes_[taken_ - 1], &before = changes_[taken_ - 2];
    if (last.step != change.step || last.act.has_value() != change.act.has_value()) return false;
    if (!change.act)
        return differences(before.description, last.description) == differences(last.description, change.description) &&
               altered_particles(before.description, last.description) ==
                   altered_particles(last.description, change.description);
    return overwrites(*change.act, *last.act);
}

std::optional<TimeLine::Branch> TimeLine::append(SegmentBegin change, bool may_replace) {
    const std::uint64_t step = change.step;
    std::optional<Branch> left = cut(step, taken_);
    if (may_replace && replaces_last(change)) {
        change.held = changes_.back().held;
        cut(step, taken_ - 1);
        stand_at(step, taken_ - 1);
    } else if (!continues(changes_.back(), change)) {
        moments_.keep(run_, taken_, first_of_last(past()));  // what may be taken back is often taken back at once
    }
    changes_.push_back(std::move(change));
    ended_ = false;
    take_due_changes();
    return left;
}

/// The run as it was at a step before later changes of that step.
void TimeLine::stand_at(std::uint64_t step, std::size_t changes) {
    go_back_to(moments_.before(step, changes));
    advance(step - run_.step());
}

/// Forgets what lies behind this step and more changes than these.
std::optional<TimeLine::Branch> TimeLine::cut(std::uint64_t step, std::size_t kept) {
    settle();
    const bool nothing = changes_.size() == kept && reached_ <= step;
    Branch branch{changes_, moments_.cut(step, kept), step, reached_, reached_time_};
    if (samples_) {
        branch.samples = samples_->cut(step);
        branch.followed = samples_->followed();
    }
    if (samples_ && step == 0) samples_->clear();  // the start may become another
    branch.ended = ended_;
    changes_.resize(kept);
    reached_ = step;
    reached_time_ = time_of(step);
    if (!nothing) ended_ = false;
    return nothing ? std::nullopt : std::optional(std::move(branch));
}

std::optional<TimeLine::Branch> TimeLine::undo() {
    if (taken_ == 1) return std::nullopt;
    const std::size_t kept = first_of_last(past());
    const std::uint64_t step = changes_[kept].step;
    std::optional<Branch> left = cut(step, kept);
    stand_at(step, kept);
    return left;
}

void TimeLine::keep_changes(std::size_t count) {
    if (count >= changes_.size()) return;
    const std::uint64_t step = changes_[count].step;
    const bool beyond = taken_ > count;
    cut(step, count);
    if (!beyond) return;
    go_back_to(moments_.before(step, count));
    asked_ = run_.step();
}

std::optional<TimeLine::Branch> TimeLine::take(Branch branch) {
    const std::size_t shared = same_changes(changes_, branch.changes);
    const std::uint64_t step = std::min(branch.fork, first_difference(changes_, branch.changes).value_or(branch.fork));
    std::optional<Branch> left = cut(step, shared);
    stand_at(step, shared);
    changes_ = std::move(branch.changes);
    moments_.append(std::move(branch.moments));
    reached_ = branch.reached;
    reached_time_ = branch.reached_time;
    ended_ = branch.ended;
    if (samples_) samples_->append(std::move(branch.samples), branch.followed);
    take_due_changes();
    return left;
}

}  // namespace steplab
