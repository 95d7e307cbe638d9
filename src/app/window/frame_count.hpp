#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>

namespace steplab {

/// Counts what a window draws, to measure how fast it does. It never reads a clock itself: times are handed in.
class FrameCount {
public:
    using Time = std::chrono::steady_clock::time_point;

    /// The window was drawn.
    void drew_frame() { ++frames_; }
    /// A new picture of the scene was taken for it.
    void took_picture() { ++pictures_; }

    /// Both numbers, "frames pictures", each second in which the window was drawn.
    std::optional<std::string> news(Time now) {
        if (frames_ == told_ || now < next_) return std::nullopt;
        told_ = frames_;
        next_ = now + std::chrono::seconds(1);
        return std::to_string(frames_) + " " + std::to_string(pictures_);
    }

private:
    std::uint64_t frames_ = 0, pictures_ = 0, told_ = 0;
    Time next_{};
};

}  // namespace steplab
