#pragma once

#include "lab/study/reference.hpp"
#include "sim/run/run_description.hpp"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace steplab {

/// What a run costs and how wrong it is at the end.
struct CostPoint {
    RunDescription run;
    double evaluations = 0;    ///< of the force, start included
    double error = 0;          ///< largest distance of a particle from the reference [m], no less than its error
    double seconds = 0;        ///< of the stepping, under any other load
    bool provisional = false;  ///< the error is against a quick reference: the same run may come once more
    friend bool operator==(const CostPoint&, const CostPoint&) = default;
};

/// The work-precision diagram of a scene, run by run, so that there is something to see at once: a run of every method
/// in both precisions with a large dt, then with half of it, and so on until a series gains no more or its next run
/// would take too long; methods that choose their steps by tolerances. Where the reference is a run, the first point of
/// each series is against a quick reference, and all come once more where there is a better one. First runs that take
/// too long come last. The same scene gives the same points in the same order, but for the series that time
/// ends or puts off.
class CostScan {
public:
    /// A series ends before a run that would take longer, in seconds.
    static constexpr double most_seconds_a_run = 0.05;

    /// Method, dt and precision of the description are ignored. `time`: where the runs end; none: time_for().
    explicit CostScan(const RunDescription& scene, std::optional<double> time = std::nullopt,
                      double seconds_a_run = most_seconds_a_run);
    ~CostScan();
    CostScan(CostScan&&) noexcept;
    CostScan& operator=(CostScan&&) noexcept;

    /// A time over which methods differ: the scene's own, or 200 of the steps that it is opened with [s].
    static double time_for(const RunDescription& scene);
    double time() const;
    /// The reference, in words; known after the first point.
    std::string how() const;
    /// Whether errors are against a quick reference so far; false before the first point.
    bool provisional() const;

    /// A run of the scan, or one that was provisional once more; none at its end. Where a run diverges, the next one is
    /// taken. Throws UsageError, Interrupted.
    std::optional<CostPoint> next();
    /// What a run of this scene costs over the time, its dt shortened to a whole number of steps; none if it diverges.
    /// Throws UsageError, Interrupted.
    std::optional<CostPoint> cost_of(const RunDescription& run);
    /// The fraction of the series that are complete.
    double done() const;

private:
    struct Body;
    std::unique_ptr<Body> body_;
};

/// Adds a point of a scan to those before, or puts it in the place of that of the same run.
void put(std::vector<CostPoint>& points, CostPoint point);

}  // namespace steplab
