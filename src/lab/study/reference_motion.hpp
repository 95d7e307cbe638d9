#pragma once

#include "lab/study/reference.hpp"
#include "sim/ensemble/live_ensemble.hpp"

#include <memory>
#include <span>
#include <string>

namespace steplab {

/// The motion of a scene as accurately as it can be known, at one time after the other: a reference that goes along
/// with runs. Exact as long as a closed form is valid; otherwise two runs in long double of the same extrapolation as
/// reference(), with steps of their own and dense output, whose difference is the estimate of the error. What it says
/// of a time depends on nothing but the scene, in double, and what was done to it: not on the times that were asked for
/// before.
class ReferenceMotion {
public:
    /// The method, dt and precision of the description are ignored. Throws UsageError.
    explicit ReferenceMotion(const RunDescription& description);
    ~ReferenceMotion();
    ReferenceMotion(ReferenceMotion&&) noexcept;
    ReferenceMotion& operator=(ReferenceMotion&&) noexcept;

    /// From here on what is done to the scene is that of these changes of a run, the first of which is its start: acts,
    /// and parameters of the scene, each at its time. Throws UsageError.
    void follow(std::span<const SegmentBegin> changes);

    /// At a time >= 0; times that grow cost least, as the runs otherwise begin again. Its error is infinite where no
    /// step of the runs met their tolerance. Throws Interrupted.
    ReferenceMoment at(double time);
    /// True if what at() said last is the closed form.
    bool is_exact() const;
    /// What at() said last, in words.
    std::string how() const;

private:
    struct Body;
    std::unique_ptr<Body> body_;
};

}  // namespace steplab
