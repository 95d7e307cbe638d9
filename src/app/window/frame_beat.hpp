#pragma once

#include <algorithm>
#include <chrono>
#include <utility>

namespace steplab {

/// When a window draws its frames: 60 a second at most, as a virtual display does not wait for a refresh. A frame that
/// comes a little late does not delay the next one. It never reads a clock itself: times are handed in.
class FrameBeat {
public:
    using Clock = std::chrono::steady_clock;
    using Time = Clock::time_point;

    static constexpr Clock::duration frame_time =
        std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(1.0 / 60));

    explicit FrameBeat(Time now) : drawn_(now), counted_(now), shown_(now) {}

    /// Input or a picture waits for the next frame.
    void hurry() { urgent_ = true; }
    /// When the next one is due. What waits for one does not wait for those that looked as before, which take little
    /// time.
    Time due() const {
        if (!urgent_) return counted_ + frame_time;
        return std::max(shown_ + frame_time, counted_ + frame_time / 4);
    }
    /// A frame begins. Returns how long after the one before.
    Clock::duration draw(Time now) {
        const Time wanted = due();
        counted_ = now - wanted < frame_time / 2 ? std::min(now, wanted) : now;
        urgent_ = false;
        return now - std::exchange(drawn_, now);
    }
    /// It looks otherwise than the one before.
    void show() { shown_ = counted_; }

private:
    Time drawn_;    ///< when the last frame began
    Time counted_;  ///< from when the next one is counted
    Time shown_;    ///< the same of the last one that looked otherwise than the one before
    bool urgent_ = false;
};

}  // namespace steplab
