#include "session/late_samples.hpp"

#include <algorithm>

namespace steplab {

namespace {

/// Memory for moments to come back to: as a rule it only goes forward.
constexpr std::size_t few_bytes = std::size_t{1} << 20;
/// Between two questions whether to stop: particles times steps, and steps.
constexpr std::uint64_t late_piece = 1 << 14, most_late_steps = 512;

}  // namespace

bool LateSamples::take(TimeLine& leading, std::span<FollowerRun> followers, const std::function<bool()>& enough) {
    found_ = false;
    if (!take(leading, enough)) return false;
    leading_again_.reset();
    again_.resize(followers.size());
    for (std::size_t i = 0; i < followers.size(); ++i) {
        if (!take(leading, followers[i], again_[i], enough)) return false;
    }
    return true;
}

/// Of the leading run as far as it has got: while this goes on it may get farther, taking samples itself.
bool LateSamples::take(TimeLine& leading, const std::function<bool()>& enough) {
    if (!leading.lacks_samples(leading.reached())) return true;
    if (!leading_again_) leading_again_.emplace(leading.again(few_bytes));
    TimeLine& again = *leading_again_;
    const std::uint64_t most = std::clamp<std::uint64_t>(late_piece / again.run().particles(), 1, most_late_steps);
    bool there = false;
    do {
        again.advance(std::min(most, leading.reached() - std::min(leading.reached(), again.run().advanced().step)));
        there = again.run().advanced().step >= leading.reached() || again.is_over();
    } while (!there && !enough());
    leading.take_samples(again);
    found_ = true;
    return there;
}

/// Of a run beside it up to the same time, by all changes that the leading one will make until then.
bool LateSamples::take(const TimeLine& leading, FollowerRun& follower, Again& again,
                       const std::function<bool()>& enough) {
    TimeLine& line = follower.line();
    const double end = leading.reached_time();
    const std::uint64_t until = line.step_at(end);
    const bool ahead = line.reached() < until && !line.is_over() && !again.knows(end);
    if (!ahead && !line.lacks_samples(std::min(until, line.reached()))) return true;
    if (!again.run) {
        again.run.emplace(follower.description(), few_bytes);
        again.run->line().sample_as(leading);
    }
    const auto changes = leading.changes();
    const bool there = again.run->follow({changes, changes.size(), end}, enough);
    const TimeLine& known = again.run->line();
    line.take_samples(known);
    found_ = true;
    if (!there) return false;
    again.samples.assign(known.samples().begin(), known.samples().end());
    again.until = end;
    again.over = known.is_over();
    again.run.reset();
    return true;
}

void LateSamples::put_ahead_into(std::size_t follower, SampleSeries& series) const {
    if (follower >= again_.size() || again_[follower].samples.empty()) return;
    const Again& again = again_[follower];
    const std::uint64_t last = series.samples.empty() ? 0 : series.samples.back().step;
    const auto first = std::upper_bound(again.samples.begin(), again.samples.end(), last,
                                        [](std::uint64_t step, const Sample& sample) { return step < sample.step; });
    if (first == again.samples.end()) return;
    series.samples.insert(series.samples.end(), first, again.samples.end());
    series.stretch.reset();  // what comes next does not continue these
}

}  // namespace steplab
