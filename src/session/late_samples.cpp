#include "session/late_samples.hpp"

#include <algorithm>

namespace steplab {

namespace {

/// Memory for moments to come back to: it only goes forward.
constexpr std::size_t few_bytes = std::size_t{1} << 20;
/// Particles times steps between two questions whether to stop: short beside the time between two pictures.
constexpr std::uint64_t piece = 1 << 14;

}  // namespace

bool LateSamples::take(TimeLine& leading, std::span<FollowerRun> followers, const std::function<bool()>& enough) {
    for (; run_ <= followers.size(); ++run_) {
        if (!(run_ == 0 ? take(leading, enough) : take(leading, followers[run_ - 1], enough))) return false;
        leading_again_.reset();
        follower_again_.reset();
        known_ = 0;
    }
    return true;
}

/// Of the leading run as far as it has got: while this goes on it may get farther, taking samples itself.
bool LateSamples::take(TimeLine& leading, const std::function<bool()>& enough) {
    if (!leading.lacks_samples(leading.reached())) return true;
    if (!leading_again_) leading_again_.emplace(leading.again(few_bytes));
    TimeLine& again = *leading_again_;
    const std::uint64_t stretch = std::max<std::uint64_t>(1, piece / again.run().particles());
    while (again.run().advanced().step < leading.reached() && !again.is_over()) {
        if (enough()) {
            hand_over(again, leading);
            return false;
        }
        again.advance(std::min(stretch, leading.reached() - again.run().advanced().step));
    }
    hand_over(again, leading);
    return true;
}

/// Of a run beside it up to the same time, by all changes that the leading one will make until then.
bool LateSamples::take(const TimeLine& leading, FollowerRun& follower, const std::function<bool()>& enough) {
    if (!follower.line().lacks_samples(follower.line().step_at(leading.reached_time()))) return true;
    if (!follower_again_) {
        follower_again_.emplace(follower.description(), few_bytes);
        follower_again_->line().sample_as(leading);
    }
    const auto changes = leading.changes();
    const bool there = follower_again_->follow({changes, changes.size(), leading.reached_time()}, enough);
    hand_over(follower_again_->line(), follower.line());
    return there;
}

void LateSamples::hand_over(const TimeLine& again, TimeLine& line) {
    line.take_samples(again, known_);
    found_ = true;
    known_ = again.run().advanced().step + 1;
}

}  // namespace steplab
