#pragma once

#include <array>
#include <cstddef>

namespace steplab::ui {

/// How coarse the picture of the scene is drawn while the camera moves, so that it follows the pointer: it has 1, 1/2
/// or 1/4 of the pixels in each direction and is enlarged 1, 2 or 4 times. Chosen by the times that pictures took.
class Coarseness {
public:
    static constexpr int coarsest = 4;
    /// Seconds that a picture may take while the camera moves: after the one that is under way, and with a frame of the
    /// window, it is on the screen within 50 ms.
    static constexpr double enough = 0.02;

    /// A picture that is enlarged so many times took so long to draw.
    void took(int enlarged, double seconds);
    /// How many times to enlarge the next picture: the least that is fast enough; 1 while the camera stands still.
    int next(bool camera_moves) const;

private:
    static constexpr std::size_t levels = 3;
    double expected(std::size_t level) const;

    std::array<double, levels> seconds_{};  ///< by level, enlarged 2^level times; 0: not known
};

}  // namespace steplab::ui
