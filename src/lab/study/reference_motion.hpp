#pragma once

#include "lab/study/reference.hpp"

#include <memory>
#include <optional>
#include <string>

namespace steplab {

/// The motion of a scene as accurately as it can be known, at one time after the other: a reference that goes along
/// with runs. Exact as long as a closed form is valid; otherwise two runs in long double of the same extrapolation as
/// reference(), with steps of their own and dense output, whose difference is the estimate of the error. What it says
/// of a time depends on nothing but the scene, with parameters in its precision: not on the times that were asked for
/// before.
class ReferenceMotion {
public:
    /// The method and dt of the description are ignored. Throws UsageError.
    explicit ReferenceMotion(const RunDescription& description);
    ~ReferenceMotion();
    ReferenceMotion(ReferenceMotion&&) noexcept;
    ReferenceMotion& operator=(ReferenceMotion&&) noexcept;

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
