#pragma once

#include "session/follower_run.hpp"
#include "session/time_line.hpp"

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace steplab {

/// Samples of where the runs of a session were that were not taken there: those of another particle, of before plots
/// were shown; and of the way ahead of runs beside the leading one that they have not gone again. The same way is gone
/// once more beside the session, a piece at a time. To be thrown away when something is done to the runs.
class LateSamples {
public:
    /// Goes on until `enough` says so; true if none is lacking any more. Throws UsageError, Interrupted.
    bool take(TimeLine& leading, std::span<FollowerRun> followers, const std::function<bool()>& enough);
    /// True if some were found by the last call.
    bool found() const { return found_; }
    /// Adds those of the way ahead of a run beside the leading one to its own.
    void put_ahead_into(std::size_t follower, SampleSeries& series) const;

private:
    /// A run beside the leading one that goes its way once more.
    struct Again {
        std::optional<FollowerRun> run;  ///< until it is there
        std::vector<Sample> samples;     ///< then
        std::optional<double> until;     ///< the time that it got to
        bool over = false;               ///< there is nothing beyond
        bool knows(double time) const { return until && (over || *until >= time); }
    };

    bool take(TimeLine& leading, const std::function<bool()>& enough);
    bool take(const TimeLine& leading, FollowerRun& follower, Again& again, const std::function<bool()>& enough);

    std::optional<TimeLine> leading_again_;
    std::vector<Again> again_;
    bool found_ = false;
};

}  // namespace steplab
