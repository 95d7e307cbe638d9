#pragma once

#include "session/follower_run.hpp"
#include "session/time_line.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>

namespace steplab {

/// Samples of where the runs of a session were that were not taken there: those of another particle, of before plots
/// were shown, of a way that runs beside the leading one have not gone again. The same way is gone once more beside the
/// session, a piece at a time. To be thrown away when something is done to the runs.
class LateSamples {
public:
    /// Goes on until `enough` says so; true if none is lacking any more. Throws Interrupted.
    bool take(TimeLine& leading, std::span<FollowerRun> followers, const std::function<bool()>& enough);

    /// True if there were some.
    bool found() const { return found_; }

private:
    bool take(TimeLine& leading, const std::function<bool()>& enough);
    bool take(const TimeLine& leading, FollowerRun& follower, const std::function<bool()>& enough);
    void hand_over(const TimeLine& again, TimeLine& line);

    std::size_t run_ = 0;  ///< which one's are taken, 0: the leading one's
    std::optional<TimeLine> leading_again_;
    std::optional<FollowerRun> follower_again_;
    std::uint64_t known_ = 0;  ///< samples of that run before this step were handed over
    bool found_ = false;
};

}  // namespace steplab
