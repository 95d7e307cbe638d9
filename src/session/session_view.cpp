#include "session/session_view.hpp"

#include "session/change_text.hpp"
#include "session/session.hpp"
#include "session/tug.hpp"

#include <algorithm>
#include <iterator>
#include <span>

namespace steplab {

namespace {

/// The time of the last change that was more than a new velocity.
double smooth_since(std::span<const SegmentBegin> past) {
    const auto leaves_places = [](const SegmentBegin& change) {
        return change.act && !std::holds_alternative<Pull>(*change.act);
    };
    return std::find_if_not(past.rbegin(), std::prev(past.rend()), leaves_places)->time;
}

}  // namespace

void Session::observe(SessionView& view) const {
    RunView& leading = view.leading;
    steplab::observe(run(), tracked(), leading);
    if (with_forces_) run().forces(leading.frame.forces);
    leading.frame.magnified = magnified_;
    line_.put_samples_into(leading.series);
    leading.swatch = swatch_;
    leading.playing = playing_ && (backwards_ || !leading.divergence);
    leading.goal = goal_;
    leading.ensemble = ensemble_;
    leading.ensemble_spread = {.step = live_ensemble_ ? live_ensemble_->step() : 0};
    if (ensemble_is_beside()) leading.ensemble_spread = live_ensemble_->observe(leading.frame);
    spread_ ? spread_->put_into(leading.spread) : void(leading.spread = {});
    leading.can_step_back = run().step() > 0;
    leading.rate = rate_;
    leading.run = number_;
    leading.smooth_since = smooth_since(line_.past());
    view.followers.resize(followers_.size());
    for (std::size_t i = 0; i < followers_.size(); ++i) {
        steplab::observe(followers_[i].run(), tracked(), view.followers[i]);
        view.followers[i].frame.magnified = magnified_;
        view.followers[i].swatch = followers_[i].swatch();
        followers_[i].line().put_samples_into(view.followers[i].series);
        late_.put_ahead_into(i, view.followers[i].series);
    }
    view.line = line_view();
    view.equal_cost = equal_cost_;
    view.not_equal = equal_cost_ ? not_equal_ : "";
}

TimeLineView Session::line_view() const {
    TimeLineView view{.reached = line_.reached(), .reached_time = line_.reached_time(), .bookmarks = bookmarks_};
    const auto changes = line_.changes();
    for (std::size_t i = 1; i < changes.size(); ++i) {
        if (continues(changes[i - 1], changes[i])) continue;
        view.changes.push_back({changes[i].step, changes[i].time, text_of(changes[i - 1], changes[i])});
    }
    for (const TimeLine::Branch& branch : branches_)
        view.branches.push_back({line_.time_of(branch.fork), branch.reached_time});
    view.can_undo = can_undo();
    view.can_redo = !undone_.empty();
    view.backwards = plays_backwards();
    if (loop_) view.loop = {line_.time_of(loop_->first), line_.time_of(loop_->last)};
    return view;
}

}  // namespace steplab
