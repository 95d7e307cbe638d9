#pragma once

#include "lab/study/reference_motion.hpp"
#include "session/step_samples.hpp"
#include "session/time_line.hpp"

#include <cstdint>
#include <mutex>
#include <span>
#include <vector>

namespace steplab {

/// How far a run is from the motion of its scene at one of its steps.
struct ErrorSample {
    std::uint64_t step = 0;
    double time = 0;             ///< [s]
    double error = 0;            ///< largest distance of a particle from the reference [m]
    double reference_error = 0;  ///< estimated [m]; 0 of an exact solution
};
using ErrorSeries = SampleSeriesOf<ErrorSample>;

/// The position errors of a run at the steps of a grid. The run is computed a second time, as fast as the reference
/// beside it allows, so that no step of the grid is left out however fast the run itself goes: the same run has the
/// same errors on every machine.
class ErrorSamples {
public:
    /// From its start. Throws UsageError.
    explicit ErrorSamples(const RunDescription& start);

    /// True if it is of the run with this start.
    bool begins_with(const RunDescription& start) const { return changes_.front().description == start; }
    /// What was done to the run, the first being its start, and the last step that it got to. What is known behind the
    /// first difference from before is forgotten. Throws UsageError for another start.
    void follow(std::span<const SegmentBegin> changes, std::uint64_t reached);
    /// True if a step of the grid that the run was at is not known yet.
    bool is_due() const;
    /// Takes the next one. Throws UsageError, Interrupted.
    void take();

    /// The motion up to a time that is no earlier than that of the last sample.
    ReferenceMotion& motion() { return motion_; }
    /// True if nothing is due, and the run stands where it got to: motion() may then be asked for its time.
    bool is_beside(std::uint64_t step) const { return !is_due() && step == reached_; }
    /// Copies what is new there; also from another thread than the rest.
    void put_into(ErrorSeries& series) const;

private:
    std::uint64_t next() const;
    void go_to(std::uint64_t step);

    TimeLine line_;
    ReferenceMotion motion_;
    std::vector<SegmentBegin> changes_;  ///< of the run; those that lie ahead too
    std::uint64_t reached_ = 0;
    mutable std::mutex mutex_;  ///< of the rows
    StepSamples<ErrorSample> rows_;
};

}  // namespace steplab
