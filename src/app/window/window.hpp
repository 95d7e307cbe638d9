#pragma once

#include "ui/display.hpp"
#include "ui/input.hpp"

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

struct GLFWwindow;

namespace steplab {

/// Initialises the window library and terminates it. Throws GraphicsError, naming what was tried, if there is no
/// display.
class WindowSystem {
public:
    WindowSystem();
    ~WindowSystem();
    WindowSystem(const WindowSystem&) = delete;
    WindowSystem& operator=(const WindowSystem&) = delete;
};

/// A window with an OpenGL 3.3 core context; its input becomes events of the interface. For the main thread only.
class Window {
public:
    /// Throws GraphicsError if the window or OpenGL 3.3 is not available. `scale` replaces the scale of the display.
    Window(int width, int height, std::optional<float> scale);
    ~Window();
    Window(const Window&) = delete;
    Window& operator=(const Window&) = delete;

    /// Sends events of keyboard and mouse to this input, which has to outlive the window.
    void listen(ui::Input& input) { input_ = &input; }
    /// Its size on the screen, which a window can be opened with; none while it fills the screen.
    std::optional<std::pair<int, int>> size() const;
    /// The current surface in pixels; its width is 0 while the window is minimised.
    ui::Display display() const;
    bool closing() const;

    /// The paths of files dropped onto the window since the last call.
    std::vector<std::string> take_dropped() { return std::exchange(dropped_, {}); }
    /// True if there was input, a change of size or an exposure since the last call.
    bool take_touched();
    /// True if what it shows may have been lost since the last call.
    bool take_exposed() { return std::exchange(exposed_, false); }
    /// Sleeps until an event or wake(), at most `seconds`.
    void wait(double seconds);
    /// Ends a wait(); may be called from any thread.
    static void wake();

    void make_current();
    void show_picture();
    void toggle_full_screen();
    void copy(const std::string& text);
    /// The text on the clipboard; empty if there is none.
    std::string pasted() const;
    GLFWwindow* handle() const { return window_.get(); }

private:
    struct Deleter {
        void operator()(GLFWwindow* window) const;
    };
    struct Events;
    struct Place {
        int x = 0, y = 0, width = 0, height = 0;
    };

    std::unique_ptr<GLFWwindow, Deleter> window_;
    std::optional<float> scale_;
    ui::Input* input_ = nullptr;
    bool touched_ = true, exposed_ = true;
    std::vector<std::string> dropped_;
    Place windowed_;  ///< place to restore after full screen
};

/// An OpenGL 3.3 context for drawing on another thread. It shares textures and fences with the context of a window, but
/// not framebuffers and vertex arrays.
class DrawingContext {
public:
    /// Throws GraphicsError if there is no such context.
    explicit DrawingContext(const Window& window);
    ~DrawingContext();
    DrawingContext(const DrawingContext&) = delete;
    DrawingContext& operator=(const DrawingContext&) = delete;

    /// To be called on the thread that draws.
    void make_current();
    void release();

private:
    GLFWwindow* window_;
};

}  // namespace steplab
