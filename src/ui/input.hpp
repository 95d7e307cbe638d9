#pragma once

#include "ui/keys.hpp"

#include <imgui.h>

#include <deque>
#include <variant>

namespace steplab::ui {

/// What happened at the keyboard and the mouse, in the order it happened, whatever window library reports it.
struct PointerMoved {
    float x = 0;
    float y = 0;
};  ///< pixels
struct ButtonChanged {
    int button = 0;
    bool down = false;
};  ///< 0 left, 1 right, 2 middle
struct WheelTurned {
    float lines = 0;
};
struct KeyChanged {
    Key key = Key::none;
    bool down = false;
};
struct ModifiersChanged {
    bool control = false;
    bool shift = false;
    bool alt = false;
};
struct TextTyped {
    unsigned character = 0;
};  ///< Unicode
struct FocusLost {};
using InputEvent =
    std::variant<PointerMoved, ButtonChanged, WheelTurned, KeyChanged, ModifiersChanged, TextTyped, FocusLost>;

/// Hands events to ImGui, at most one press or release of a button or key in a frame, and what was dragged before it is
/// let go: a click or drag that is over within one frame of a slow machine must not be lost. It is the one place that
/// knows how ImGui's versions take input.
class Input {
public:
    void push(const InputEvent& event) { events_.push_back(event); }
    /// Feeds the next frame. True if events are left for another frame.
    bool feed(ImGuiIO& io);

    /// Tells ImGui which of its own keys ours are; once per context.
    static void describe_keys(ImGuiIO& io);
    /// True if the key went down in this frame, or repeats while it is held if `repeat`.
    static bool pressed(Key key, bool repeat);

private:
    static bool ends_a_drag(const InputEvent& event, bool moved);

    std::deque<InputEvent> events_;
};

}  // namespace steplab::ui
