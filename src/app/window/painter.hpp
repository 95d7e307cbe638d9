#pragma once

#include "app/window/window.hpp"
#include "render/camera.hpp"
#include "render/fence.hpp"
#include "render/following.hpp"
#include "render/picture_texture.hpp"
#include "render/style.hpp"
#include "session/session_view.hpp"

#include <chrono>
#include <condition_variable>
#include <exception>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>

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

/// A finished picture. Its texture belongs to the context of the window, and to that of the painter if they share it.
struct Painted {
    render::PictureTexture texture;
    render::TexturePixels copied = {};                  ///< it, where they do not
    render::Fence shown = {};                           ///< after all that the window has drawn with it
    std::chrono::steady_clock::time_point requested{};  ///< as ask() was told
    double seconds = 0;                                 ///< time to draw it
    int enlarged = 1;                                   ///< as its style said
    std::shared_ptr<const SessionView> view = {};       ///< that it shows
};

/// Draws the scene on its own thread and in its own OpenGL context, so that a slow picture never delays the panels.
/// Only the newest job is drawn. The picture stays where it was drawn: one texture is shown, one is finished, and one
/// is drawn, and they change places. Only where the driver is one for a single thread has the painter one of its own,
/// and its pictures are copied.
class ScenePainter {
public:
    /// To be made and used while the context of the window is current. `wake` is called on the thread of the painter
    /// when a picture is finished. Throws the errors of the renderer.
    ScenePainter(const Window& window, void (*wake)());
    ~ScenePainter();

    /// Requests a picture at this time, unless it equals the last request: false, then.
    bool ask(const PaintJob& job, std::chrono::steady_clock::time_point now);
    /// Swaps the newest picture into `picture` if it was not taken yet; what was there is drawn over once the window
    /// has done with it. The new picture is complete: showing it waits for nothing. Throws the error that drawing it
    /// caused.
    bool take(Painted& picture);
    /// True if pictures stay where they were drawn.
    bool shares_textures() const { return shared_.has_value(); }

private:
    void work();
    void draw_jobs(Painting& painting);
    struct Request {
        PaintJob job;
        std::chrono::steady_clock::time_point time;
    };
    std::optional<Request> next_request();
    void finish(Painting& painting, const Request& request, double seconds);

    std::optional<DrawingContext> shared_;  ///< none: the painter has a driver of its own
    void (*wake_)();
    std::mutex mutex_;
    std::condition_variable changed_;
    std::optional<Request> asked_;  ///< newest one, not started yet
    std::optional<PaintJob> last_;  ///< last request
    bool stopping_ = false;
    bool fresh_ = false;
    bool started_ = false;
    std::exception_ptr failure_;
    Painted ready_;
    std::thread thread_;
};

}  // namespace steplab
