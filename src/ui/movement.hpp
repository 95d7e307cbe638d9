#pragma once

#include <chrono>

namespace steplab::ui {

/// Whether the camera or what is dragged moves, so that pictures have to be quick: until it has stood still for a
/// while, and a picture that was requested since then shows where it is. It never reads a clock itself: times are
/// handed in.
class Movement {
public:
    using Time = std::chrono::steady_clock::time_point;
    /// What has not moved for so long is at rest.
    static constexpr std::chrono::milliseconds time_to_rest{300};

    /// A frame finds it moved.
    void seen(Time now);
    /// The frame has requested a picture; `another`: that differs from the one it requested last.
    void requested(Time now, bool another);
    /// A picture is finished that was requested then.
    void pictured(Time requested, bool coarse, Time now);
    bool goes_on(Time now) const { return awaits_picture_ || now < seen_ + time_to_rest; }
    /// When it will be at rest; the largest time while its picture is not finished.
    Time rest() const { return awaits_picture_ ? Time::max() : seen_ + time_to_rest; }
    void end() { *this = {}; }

private:
    Time seen_{};
    bool awaits_picture_ = false;
};

}  // namespace steplab::ui
