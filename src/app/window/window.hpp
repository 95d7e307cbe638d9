#pragma once

#include "ui/display.hpp"
#include "ui/input.hpp"

#include <memory>
#include <optional>
#include <string>

struct GLFWwindow;

namespace steplab {

/// The window library from its start to its end. Throws GraphicsError, naming what was tried, if there is no display.
class WindowSystem {
public:
    WindowSystem();
    ~WindowSystem();
    WindowSystem(const WindowSystem&) = delete;
    WindowSystem& operator=(const WindowSystem&) = delete;
};

/// A window with an OpenGL 3.3 core context, its input as events of the interface. Belongs to the main thread.
class Window {
public:
    /// Throws GraphicsError if the window, or OpenGL 3.3, cannot be had. `scale`: instead of what the display says.
    Window(int width, int height, std::optional<float> scale);
    ~Window();
    Window(const Window&) = delete;
    Window& operator=(const Window&) = delete;

    /// Hands keyboard and mouse to this input from now on; it outlives the window.
    void listen(ui::Input& input) { input_ = &input; }
    /// The surface as it is now, in pixels; nothing of it (width 0) while the window is minimised.
    ui::Display display() const;
    bool closing() const;

    /// True if anything happened to the window since the last call: input, size, exposure.
    bool take_touched();
    /// Sleeps until something happens or wake() is called, at most `seconds`.
    void wait(double seconds);
    /// Ends a wait(); may be called from any thread.
    static void wake();

    void make_current();
    void show_picture();
    void toggle_full_screen();
    void copy(const std::string& text);
    /// What other programs copied; empty where it is no text.
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
    bool touched_ = true;
    Place windowed_;  ///< where to come back to from full screen
};

/// An OpenGL 3.3 context without a window, for drawing on another thread. It shares nothing with the window's: where
/// OpenGL is computed by the processor, drawings of one driver's screen wait for each other, whatever their contexts;
/// so this one comes by another way (EGL) where there is one.
class DrawingContext {
public:
    DrawingContext();
    ~DrawingContext();
    DrawingContext(const DrawingContext&) = delete;
    DrawingContext& operator=(const DrawingContext&) = delete;

    /// On the thread that draws.
    void make_current();
    void release();

private:
    GLFWwindow* window_;
};

}  // namespace steplab
