#pragma once

#include "app/view_window.hpp"
#include "render/camera.hpp"
#include "render/style.hpp"
#include "sim/run_view.hpp"

#include <array>
#include <condition_variable>
#include <cstdint>
#include <exception>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>

namespace steplab {

class Painting;

/// A picture of the scene as it is asked for.
struct PaintJob {
    std::shared_ptr<const RunView> view;
    render::Style style;
    render::Camera camera;
    render::PictureSize size;
    friend bool operator==(const PaintJob&, const PaintJob&) = default;
};

/// A picture that is done.
struct Painted {
    std::uint32_t texture = 0;  ///< valid until the next one is taken
    double seconds = 0;         ///< it took
};

/// Draws the scene on a thread of its own, so that a heavy picture never holds up the panels. Only the newest job
/// counts; three pictures go round: one is shown, one is done, one is being drawn.
class ScenePainter {
public:
    /// `wake` is called from the painter's thread when a picture is done. Throws what the renderer throws.
    ScenePainter(const Window& window, void (*wake)());
    ~ScenePainter();

    /// Asks for a picture, unless the last one asked for is the same.
    void ask(const PaintJob& job);
    /// The newest picture, if there is one that was not taken yet. Throws what drawing it threw.
    std::optional<Painted> take();

private:
    void work();
    void draw_jobs(Painting& painting);
    std::optional<PaintJob> next_job();
    void finish(double seconds);

    SharedContext context_;
    void (*wake_)();
    std::mutex mutex_;
    std::condition_variable changed_;
    std::optional<PaintJob> asked_;  ///< newest job, not begun yet
    std::optional<PaintJob> last_;   ///< asked for last
    bool stopping_ = false;
    bool fresh_ = false;
    bool started_ = false;
    std::exception_ptr failure_;
    std::array<Painted, 3> pictures_;
    std::size_t shown_ = 0, ready_ = 1, drawn_ = 2;
    std::thread thread_;
};

}  // namespace steplab
