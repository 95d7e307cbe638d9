#pragma once

#include "session/time_line.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace steplab {

/// A run beside the leading one: of the same scene, shown at the same times, and everything that is done to particles
/// and to the scene there happens to it too, at its last step that does not lie after it.
class FollowerRun {
public:
    /// `swatch`: RunView::swatch. Throws UsageError.
    FollowerRun(const RunDescription& description, std::size_t bytes, std::size_t swatch = 1);

    /// As it began; a change of scene since then is in run().description().
    const RunDescription& description() const { return description_; }
    std::size_t swatch() const { return swatch_; }
    const Simulation& run() const { return line_.run(); }
    /// With all that was changed of the scene until where the leading run stands, whether it is there or not.
    RunDescription description_at(const TimeLine& leading) const;
    /// As it would begin beside a run that begins so in place of the leading one; none where that is another scene.
    std::optional<RunDescription> description_in(const RunDescription& beginning, const TimeLine& leading) const;
    /// Throws UsageError if it cannot go that way: all changes from a start on.
    void check_way(std::span<const SegmentBegin> way) const;
    /// Forgets samples of where the leading run does not go, or goes another way.
    void forget_other_samples(const TimeLine& leading);
    TimeLine& line() { return line_; }
    const TimeLine& line() const { return line_; }

    /// A way of the leading run: all its changes from its start on, how many of them have taken effect, and its time
    /// there [s].
    struct Course {
        std::span<const SegmentBegin> changes;
        std::size_t taken = 1;
        double time = 0;
    };
    /// Goes to where the leading run stands. Stops on the way if `enough` says so; false if it is not there yet. Throws
    /// UsageError if a change cannot be made to it, Interrupted.
    bool follow(const TimeLine& leading, const std::function<bool()>& enough);
    bool follow(const Course& leading, const std::function<bool()>& enough);
    /// True if it is there.
    bool is_beside(const TimeLine& leading) const;

    /// A description of the scene that is to run beside this line, as it begins: what was changed of the scene since
    /// the line's start will happen to it. One of another scene as it is.
    static RunDescription at_start(RunDescription description, const TimeLine& leading);

private:
    /// A change of the leading run, or its start, that happened here.
    struct Followed {
        SegmentBegin change;
        std::uint64_t at = 0;     ///< the step of this run
        std::size_t changes = 1;  ///< of its line, with it
    };

    std::size_t shared(const Course& leading) const;
    void go_back(std::size_t kept);
    bool go_to(double time, const std::function<bool()>& enough);
    void judge(std::uint64_t step);
    void take(const SegmentBegin& before, const SegmentBegin& change);
    static void take_scene(const RunDescription& before, const RunDescription& after, RunDescription& description);

    RunDescription description_;
    std::size_t bytes_;
    std::size_t swatch_;
    TimeLine line_;
    std::vector<Followed> followed_;
    std::optional<std::uint64_t> judged_;  ///< a step at which its energy is impossible: it has ended before
};

}  // namespace steplab
