#pragma once

#include "app/window/window.hpp"
#include "render/camera.hpp"
#include "render/following.hpp"
#include "render/style.hpp"
#include "session/session_view.hpp"

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

/// A request for a picture of the scene.
struct PaintJob {
    std::shared_ptr<const SessionView> view;
    std::shared_ptr<const SessionView> from;  ///< the view to interpolate from; null: none
    double fraction = 1;                      ///< position between `from` (0) and `view` (1)
    render::Style style;
    render::Camera camera;                                     ///< for the moment of `view`
    render::Following following = render::Following::nothing;  ///< what the camera goes with until then
    render::PictureSize size;
    friend bool operator==(const PaintJob&, const PaintJob&) = default;
};

/// A finished picture.
struct Painted {
    std::vector<std::uint8_t> bytes;  ///< rows from the top, 4 bytes per pixel
    render::PictureSize size;
    double seconds = 0;  ///< time to draw it
};

/// Draws the scene on its own thread and in its own OpenGL context, so that a slow picture never delays the panels.
/// Only the newest job is drawn.
class ScenePainter {
public:
    /// `wake` is called on the thread of the painter when a picture is finished. Throws the errors of the renderer.
    explicit ScenePainter(void (*wake)());
    ~ScenePainter();

    /// Requests a picture, unless it equals the last request.
    void ask(const PaintJob& job);
    /// Swaps the newest picture into `picture` if it was not taken yet. Throws the error that drawing it caused.
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
    std::optional<PaintJob> asked_;  ///< newest job, not started yet
    std::optional<PaintJob> last_;   ///< last request
    bool stopping_ = false;
    bool fresh_ = false;
    bool started_ = false;
    std::exception_ptr failure_;
    Painted ready_;
    std::thread thread_;
};

}  // namespace steplab
