#pragma once

#include "app/window/window.hpp"
#include "render/camera.hpp"
#include "render/style.hpp"
#include "sim/run/run_view.hpp"

#include <condition_variable>
#include <cstdint>
#include <exception>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

namespace steplab {

class Painting;

/// A picture of the scene as it is asked for.
struct PaintJob {
    std::shared_ptr<const RunView> view;
    std::shared_ptr<const RunView> from;  ///< the moment glided from; null: `view` as it is
    double fraction = 1;                  ///< how far from there to `view`
    render::Style style;
    render::Camera camera;
    render::PictureSize size;
    friend bool operator==(const PaintJob&, const PaintJob&) = default;
};

/// A picture that is done.
struct Painted {
    std::vector<std::uint8_t> bytes;  ///< rows from the top, 4 bytes a pixel
    render::PictureSize size;
    double seconds = 0;  ///< it took
};

/// Draws the scene on a thread and in an OpenGL context of its own, so that a heavy picture never holds up the panels.
/// Only the newest job counts.
class ScenePainter {
public:
    /// `wake` is called from the painter's thread when a picture is done. Throws what the renderer throws.
    explicit ScenePainter(void (*wake)());
    ~ScenePainter();

    /// Asks for a picture, unless the last one asked for is the same.
    void ask(const PaintJob& job);
    /// Swaps the newest picture into `picture` if there is one that was not taken yet. Throws what drawing it threw.
    bool take(Painted& picture);

private:
    void work();
    void draw_jobs(Painting& painting);
    std::optional<PaintJob> next_job();
    void finish(Painted& picture);

    DrawingContext context_;
    void (*wake_)();
    std::mutex mutex_;
    std::condition_variable changed_;
    std::optional<PaintJob> asked_;  ///< newest job, not begun yet
    std::optional<PaintJob> last_;   ///< asked for last
    bool stopping_ = false;
    bool fresh_ = false;
    bool started_ = false;
    std::exception_ptr failure_;
    Painted ready_;
    std::thread thread_;
};

}  // namespace steplab
