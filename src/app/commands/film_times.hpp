#pragma once

#include "sim/run/run_description.hpp"

#include <cstdint>
#include <optional>
#include <string>

namespace steplab {

/// How many frames show so many seconds of a run, one every `spacing` from the first moment on. Throws UsageError for
/// more frames than anyone can watch.
std::uint64_t film_frames(double seconds, double spacing);

/// The moments of a film: frame k at time k times a spacing, from 0 to the end of the run.
class FilmTimes {
public:
    /// `end`: of the run, which is asked for until `time`; `spacing` is > 0. Throws UsageError for more frames than
    /// anyone can watch.
    FilmTimes(const RunDescription& description, const RunEnd& end, double time, double spacing);

    /// How many frames there are, at least 1.
    std::uint64_t count() const { return count_; }
    /// The step at which a frame shows the run: step_at(), but its end at its end.
    std::uint64_t step(std::uint64_t frame) const;
    /// The end of the run as far as the film shows it.
    RunEnd end() const;
    /// "steps are 0.1 s long, frames 0.033 s apart: ..." where most frames show the step of that before.
    std::optional<std::string> note() const;

private:
    double dt_;
    RunEnd end_;
    double spacing_;  ///< with the sign of dt
    std::uint64_t count_ = 1;
};

}  // namespace steplab
