// When a film of what is played has its next frame.
#pragma once

#include "core/clamped.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace steplab {

/// Frame k of a film shows the last step at which no more than k times a spacing of simulated time had been played, as
/// FilmTimes has it of a run. Where the session stands or goes to another moment, no time is played. After each frame
/// the session waits until it is let go on, so that none is left out.
class FilmGate {
public:
    /// `spacing`: simulated seconds from one frame to the next, > 0. The first frame is that of now.
    explicit FilmGate(double spacing) : spacing_(spacing) {}

    /// How many frames there are, with that which shows this moment first; those that show it again are counted when it
    /// is left.
    std::uint64_t frames() const { return frames_; }
    bool waits() const { return waits_; }
    void go_on() { waits_ = false; }

    /// The moment is left: at most so many steps of dt (> 0) may be played until another frame is due, at least 1.
    std::uint64_t steps_to_frame(double dt) {
        const double frames = std::ceil((played_ + near * dt) / spacing_);
        frames_ = std::max(frames_, clamped_floor<std::uint64_t>(frames, 1, most));
        const double steps = (static_cast<double>(frames_) * spacing_ - played_) / dt + (1 - near);
        return clamped_floor<std::uint64_t>(steps, 1, most);
    }
    /// So many steps were played. True if a frame of this moment is due.
    bool played(std::uint64_t steps, double dt) {
        played_ += static_cast<double>(steps) * dt;
        waits_ = steps > 0 && static_cast<double>(frames_) * spacing_ < played_ + near * dt;
        if (waits_) ++frames_;
        return waits_;
    }

private:
    static constexpr double near = 1 - 1e-6;  ///< of a step, for rounding, as step_at() has it
    static constexpr std::uint64_t most = 1'000'000'000'000'000;

    double spacing_;
    double played_ = 0;
    std::uint64_t frames_ = 1;
    bool waits_ = true;
};

}  // namespace steplab
