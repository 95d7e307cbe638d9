#pragma once

#include "ui/keys.hpp"

#include <imgui.h>

#include <deque>
#include <variant>

namespace steplab::ui {

/// Events of keyboard and mouse, in their order, independent of the window library.
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

/// Feeds events to ImGui: at most one press or release of a button or key per frame, and a drag before its release, so
/// that a click or drag within one frame of a slow machine is not lost. Differences between ImGui's versions are
/// handled here only.
class Input {
public:
    void push(const InputEvent& event) { events_.push_back(event); }
    /// Feeds the events of the next frame. True if some are left for another frame.
    bool feed(ImGuiIO& io);

    /// Maps our keys to those of ImGui; once per context.
    static void describe_keys(ImGuiIO& io);
    /// Lets arrows, Enter, Space and Escape go from widget to widget in this frame, or not.
    static void steer(ImGuiIO& io, bool on);
    /// True if the key was pressed in this frame; with `repeat` also each time a held key repeats.
    static bool pressed(Key key, bool repeat);

private:
    static bool ends_a_drag(const InputEvent& event, bool moved);

    std::deque<InputEvent> events_;
};

/// How often one of two keys was pressed in this frame less how often the other was; a held key repeats.
int presses(Key positive, Key negative);

/// The pointer is nowhere for as long as this lives, and then where it was; its buttons stay as they are.
class PointerAway {
public:
    explicit PointerAway(ImGuiIO& io);
    ~PointerAway();
    PointerAway(const PointerAway&) = delete;
    PointerAway& operator=(const PointerAway&) = delete;

private:
    ImGuiIO& io_;
    ImVec2 place_;
};

}  // namespace steplab::ui
