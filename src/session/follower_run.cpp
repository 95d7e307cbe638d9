#include "session/follower_run.hpp"

#include <algorithm>
#include <utility>

namespace steplab {

namespace {

/// Between two questions whether to stop: particles times steps, and steps.
constexpr std::uint64_t piece = 1 << 14, most_at_once = 64;

FollowerRun::Course course_of(const TimeLine& leading) {
    return {leading.changes(), leading.past().size(), leading.time()};
}

}  // namespace

FollowerRun::FollowerRun(const RunDescription& description, std::size_t bytes, std::size_t swatch)
    : description_(description), bytes_(bytes), swatch_(swatch), line_(description, bytes) {}

bool FollowerRun::follow(const TimeLine& leading, const std::function<bool()>& enough) {
    const Course course = course_of(leading);
    go_back(shared(course));
    line_.sample_as(leading);
    return follow(course, enough);
}

/// Where the leading run has gone another way than this one, this one goes back to where they part.
bool FollowerRun::follow(const Course& leading, const std::function<bool()>& enough) {
    go_back(shared(leading));
    if (followed_.empty()) followed_.push_back({leading.changes.front()});
    while (followed_.size() < leading.taken) {
        const SegmentBegin& next = leading.changes[followed_.size()];
        if (!go_to(next.time, enough)) return false;
        take(followed_.back().change, next);
        followed_.push_back({next, line_.step(), line_.changes().size()});
    }
    return go_to(leading.time, enough);
}

bool FollowerRun::is_beside(const TimeLine& leading) const {
    const auto [step, evaluations, over] = line_.run().advanced();
    const std::uint64_t wanted = line_.step_at(leading.time());
    return followed_.size() >= leading.past().size() && shared(course_of(leading)) == followed_.size() &&
           (step == wanted || judged_ == wanted || (over && !line_.ended_beyond(wanted)));
}

/// How much of what happened to it belongs to where the leading run stands: its changes up to there, and later ones of
/// the same way unless they were done at the step at which this run is to be shown now, as its steps are longer.
std::size_t FollowerRun::shared(const Course& leading) const {
    const std::uint64_t wanted = line_.step_at(leading.time);
    std::size_t same = 0;
    while (same < std::min(followed_.size(), leading.changes.size()) &&
           followed_[same].change == leading.changes[same] && (same < leading.taken || followed_[same].at > wanted))
        ++same;
    return same;
}

/// What it did behind a change that it has not followed is not what it will do there.
void FollowerRun::forget_other_samples(const TimeLine& leading) {
    const auto changes = leading.changes();
    std::size_t same = 0;
    while (same < std::min(followed_.size(), changes.size()) && followed_[same].change == changes[same]) ++same;
    const double end = same < changes.size() ? changes[same].time : leading.reached_time();
    line_.forget_samples_behind(line_.step_at(end));
}

/// To before the first of these that is not kept.
void FollowerRun::go_back(std::size_t kept) {
    if (kept == followed_.size()) return;
    if (kept == 0) {
        line_ = TimeLine(description_, bytes_);
    } else {
        line_.keep_changes(followed_[kept - 1].changes);
    }
    followed_.resize(kept);
    judged_.reset();
}

bool FollowerRun::go_to(double time, const std::function<bool()>& enough) {
    const std::uint64_t step = line_.step_at(time);
    if (std::exchange(judged_, std::nullopt) == step && line_.is_over()) {
        judged_ = step;
        return true;
    }
    if (line_.run().advanced().step > step || line_.ended_beyond(step)) line_.turn_to_any(step);
    const std::uint64_t most = std::clamp<std::uint64_t>(piece / line_.run().particles(), 1, most_at_once);
    while (line_.run().advanced().step < step && !line_.run().advanced().diverged) {
        line_.advance(std::min(most, step - line_.run().advanced().step));
        if (line_.run().advanced().step < step && enough()) return false;
    }
    if (!line_.is_over() && !line_.run().is_plausible()) judge(step);
    if (!line_.is_over()) line_.keep_moment();
    return true;
}

/// Goes ahead to the check that decides whether it has diverged where its energy is impossible: what it computes until
/// then would be shown, and spoil what is drawn of the others. What is found depends on the step alone.
void FollowerRun::judge(std::uint64_t step) {
    line_.advance(line_.run().steps_to_check());
    if (line_.is_over()) {
        judged_ = step;
        return;
    }
    line_.turn_to_any(step);
    line_.advance(step - line_.run().advanced().step);
}

/// Of a change of description, that of the scene.
void FollowerRun::take(const SegmentBegin& before, const SegmentBegin& change) {
    if (line_.is_over()) return;
    if (change.act) {
        line_.act(*change.act);
        return;
    }
    RunDescription description = line_.run().description();
    take_scene(before.description, change.description, description);
    line_.change(description);
}

void FollowerRun::take_scene(const RunDescription& before, const RunDescription& after, RunDescription& description) {
    for (const ParameterInfo& info : description.scene.infos()) {
        const double value = after.scene[info.name];
        if (value != before.scene[info.name]) description.scene.set(info.name, value);
    }
    if (after.alterations != before.alterations) description.alterations = after.alterations;
}

RunDescription FollowerRun::at_start(RunDescription description, const TimeLine& leading) {
    const RunDescription &now = leading.run().description(), &start = leading.changes().front().description;
    if (description.model != now.model || description.origin != now.origin) return description;
    for (const ParameterInfo& info : description.scene.infos()) {
        if (description.scene[info.name] == now.scene[info.name])
            description.scene.set(info.name, start.scene[info.name]);
    }
    if (description.alterations == now.alterations) description.alterations = start.alterations;
    return description;
}

RunDescription FollowerRun::description_at(const TimeLine& leading) const {
    RunDescription description = description_;
    const auto past = leading.past();
    for (std::size_t i = 1; i < past.size(); ++i) take_scene(past[i - 1].description, past[i].description, description);
    return description;
}

std::optional<RunDescription> FollowerRun::description_in(const RunDescription& beginning,
                                                          const TimeLine& leading) const {
    const RunDescription& now = leading.run().description();
    if (beginning.model != now.model || beginning.origin != now.origin) return std::nullopt;
    RunDescription description = description_at(leading);
    take_scene(now, beginning, description);
    description.start = beginning.start;
    return description;
}

void FollowerRun::check_way(std::span<const SegmentBegin> way) const {
    RunDescription description = description_;
    for (std::size_t i = 1; i < way.size(); ++i) {
        const RunDescription &before = way[i - 1].description, &after = way[i].description;
        if (before.scene == after.scene && before.alterations == after.alterations) continue;
        take_scene(before, after, description);
        check(description);
    }
}

}  // namespace steplab
