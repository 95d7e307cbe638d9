#include "app/window/window.hpp"

#include "app/cli/driver_needs.hpp"
#include "app/window/display_loss.hpp"
#include "app/window/icon.hpp"
#include "app/window/keys.hpp"
#include "core/error.hpp"

#include <GLFW/glfw3.h>
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <utility>

namespace steplab {
namespace {

std::string last_error() {
    const char* text = nullptr;
    glfwGetError(&text);
    return text ? text : "no reason given";
}

std::string setting(const char* name) {
    const char* value = std::getenv(name);
    return value ? fmt::format("{}='{}'", name, value) : fmt::format("{} is not set", name);
}

void hint_core_profile() {
    glfwDefaultWindowHints();
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    glfwWindowHint(GLFW_DEPTH_BITS, 0);  // the scene has its own buffers; panels need no depth
    glfwWindowHint(GLFW_STENCIL_BITS, 0);
}

}  // namespace

WindowSystem::WindowSystem() {
    // Mesa's EGL would print to standard error which drivers it tried without success.
    setenv("EGL_LOG_LEVEL", "fatal", 0);
    limit_driver_threads(2);
    require_space_to_draw(driver_space);
    answer_display_loss();
    if (glfwInit() == GLFW_TRUE) return;
    throw GraphicsError(fmt::format("cannot open a window: no display ({}, {}; {})", setting("DISPLAY"),
                                    setting("WAYLAND_DISPLAY"), last_error()));
}

WindowSystem::~WindowSystem() { glfwTerminate(); }

/// Callbacks of GLFW; the user pointer of the handle is the window.
struct Window::Events {
    static Window& of(GLFWwindow* handle) { return *static_cast<Window*>(glfwGetWindowUserPointer(handle)); }

    static void push(GLFWwindow* handle, const ui::InputEvent& event) {
        Window& window = of(handle);
        window.touched_ = true;
        if (window.input_) window.input_->push(event);
    }
    static void modifiers(GLFWwindow* handle) {
        const auto down = [&](int a, int b) {
            return glfwGetKey(handle, a) == GLFW_PRESS || glfwGetKey(handle, b) == GLFW_PRESS;
        };
        push(handle, ui::ModifiersChanged{down(GLFW_KEY_LEFT_CONTROL, GLFW_KEY_RIGHT_CONTROL),
                                          down(GLFW_KEY_LEFT_SHIFT, GLFW_KEY_RIGHT_SHIFT),
                                          down(GLFW_KEY_LEFT_ALT, GLFW_KEY_RIGHT_ALT)});
    }
    static void key(GLFWwindow* handle, int key, int scancode, int action, int) {
        modifiers(handle);
        const ui::Key known = key_of(key, scancode);
        if (known != ui::Key::none && action != GLFW_REPEAT) {
            push(handle, ui::KeyChanged{known, action == GLFW_PRESS});
        }
    }
    static void button(GLFWwindow* handle, int button, int action, int) {
        modifiers(handle);
        if (button < 3) push(handle, ui::ButtonChanged{button, action == GLFW_PRESS});
    }
    static void pointer(GLFWwindow* handle, double x, double y) {
        int width = 1, height = 1, pixels_wide = 1, pixels_high = 1;
        glfwGetWindowSize(handle, &width, &height);
        glfwGetFramebufferSize(handle, &pixels_wide, &pixels_high);
        const double density = static_cast<double>(pixels_wide) / std::max(1, width);
        push(handle, ui::PointerMoved{static_cast<float>(x * density), static_cast<float>(y * density)});
    }
    static void pointer_left(GLFWwindow* handle, int entered) {
        if (entered == GLFW_FALSE) push(handle, ui::PointerMoved{-1e6f, -1e6f});
    }
    static void wheel(GLFWwindow* handle, double, double lines) {
        push(handle, ui::WheelTurned{static_cast<float>(lines)});
    }
    static void character(GLFWwindow* handle, unsigned character) { push(handle, ui::TextTyped{character}); }
    static void focus(GLFWwindow* handle, int focused) {
        if (focused == GLFW_FALSE) push(handle, ui::FocusLost{});
    }
    static void dropped(GLFWwindow* handle, int count, const char** paths) {
        Window& window = of(handle);
        window.touched_ = true;
        window.dropped_.insert(window.dropped_.end(), paths, paths + count);
    }
    static void expose(GLFWwindow* handle) { of(handle).touched_ = of(handle).exposed_ = true; }
    static void size(GLFWwindow* handle, int, int) { expose(handle); }
    static void minimised(GLFWwindow* handle, int) { expose(handle); }

    static void connect(GLFWwindow* handle) {
        glfwSetKeyCallback(handle, key);
        glfwSetMouseButtonCallback(handle, button);
        glfwSetCursorPosCallback(handle, pointer);
        glfwSetCursorEnterCallback(handle, pointer_left);
        glfwSetScrollCallback(handle, wheel);
        glfwSetCharCallback(handle, character);
        glfwSetWindowFocusCallback(handle, focus);
        glfwSetDropCallback(handle, dropped);
        glfwSetWindowRefreshCallback(handle, expose);
        glfwSetFramebufferSizeCallback(handle, size);
        glfwSetWindowIconifyCallback(handle, minimised);
    }
};

void Window::Deleter::operator()(GLFWwindow* window) const { glfwDestroyWindow(window); }

Window::Window(int width, int height, std::optional<float> scale) : scale_(scale) {
    hint_core_profile();
    window_.reset(glfwCreateWindow(width, height, "steplab", nullptr, nullptr));
    if (!window_) throw GraphicsError(fmt::format("cannot open a window with OpenGL 3.3 ({})", last_error()));
    glfwSetWindowSizeLimits(handle(), 200, 150, GLFW_DONT_CARE, GLFW_DONT_CARE);
    glfwSetWindowUserPointer(handle(), this);
    Events::connect(handle());
    set_icon(handle());
    make_current();
    glfwSwapInterval(1);
}

Window::~Window() = default;

ui::Display Window::display() const {
    ui::Display display;
    glfwGetFramebufferSize(handle(), &display.width, &display.height);
    float x = 1;
    float y = 1;
    glfwGetWindowContentScale(handle(), &x, &y);
    display.scale = scale_.value_or(std::clamp(x, 0.5f, 8.0f));
    if (glfwGetWindowAttrib(handle(), GLFW_ICONIFIED) == GLFW_TRUE) display.width = display.height = 0;
    return display;
}

std::optional<std::pair<int, int>> Window::size() const {
    if (glfwGetWindowMonitor(handle()) || glfwGetWindowAttrib(handle(), GLFW_ICONIFIED) == GLFW_TRUE)
        return std::nullopt;
    std::pair<int, int> size;
    glfwGetWindowSize(handle(), &size.first, &size.second);
    return size;
}

bool Window::closing() const { return glfwWindowShouldClose(handle()) == GLFW_TRUE; }

bool Window::take_touched() { return std::exchange(touched_, false); }

void Window::wait(double seconds) {
    // GLFW reports an error for a time that the clock of the system cannot represent.
    constexpr double longest = 3600;
    if (seconds <= 0) {
        glfwPollEvents();
    } else if (seconds > longest) {
        glfwWaitEvents();
    } else {
        glfwWaitEventsTimeout(seconds);
    }
}

void Window::wake() { glfwPostEmptyEvent(); }

void Window::make_current() { glfwMakeContextCurrent(handle()); }

void Window::show_picture() { glfwSwapBuffers(handle()); }

void Window::toggle_full_screen() {
    if (glfwGetWindowMonitor(handle())) {
        glfwSetWindowMonitor(handle(), nullptr, windowed_.x, windowed_.y, windowed_.width, windowed_.height, 0);
        return;
    }
    GLFWmonitor* monitor = glfwGetPrimaryMonitor();
    const GLFWvidmode* mode = monitor ? glfwGetVideoMode(monitor) : nullptr;
    if (!mode) return;
    glfwGetWindowPos(handle(), &windowed_.x, &windowed_.y);
    glfwGetWindowSize(handle(), &windowed_.width, &windowed_.height);
    glfwSetWindowMonitor(handle(), monitor, 0, 0, mode->width, mode->height, mode->refreshRate);
}

void Window::copy(const std::string& text) { glfwSetClipboardString(handle(), text.c_str()); }

std::string Window::pasted() const {
    const char* text = glfwGetClipboardString(handle());
    return text ? text : "";
}

DrawingContext::DrawingContext(const Window& window) : window_(nullptr) {
    hint_core_profile();
    glfwWindowHint(GLFW_VISIBLE, GLFW_FALSE);
    window_ = glfwCreateWindow(16, 16, "steplab drawing", nullptr, window.handle());
    if (!window_) throw GraphicsError(fmt::format("cannot create a second OpenGL context ({})", last_error()));
}

DrawingContext::~DrawingContext() { glfwDestroyWindow(window_); }

void DrawingContext::make_current() { glfwMakeContextCurrent(window_); }

void DrawingContext::release() { glfwMakeContextCurrent(nullptr); }

}  // namespace steplab
