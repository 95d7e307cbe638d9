#include "ui/input.hpp"

#include <imgui_internal.h>

#include <algorithm>
#include <cfloat>
#include <iterator>

namespace steplab::ui {
namespace {

struct KeyName {
    Key key;
    ImGuiKey imgui;
};

// The keys that ImGui itself acts on. ImGui 1.86 has names for these only; from 1.87 on every key has a name.
constexpr KeyName editing_keys[] = {
    {Key::space, ImGuiKey_Space},
    {Key::left, ImGuiKey_LeftArrow},
    {Key::right, ImGuiKey_RightArrow},
    {Key::up, ImGuiKey_UpArrow},
    {Key::down, ImGuiKey_DownArrow},
    {Key::backspace, ImGuiKey_Backspace},
    {Key::del, ImGuiKey_Delete},
    {Key::home, ImGuiKey_Home},
    {Key::end, ImGuiKey_End},
    {Key::page_up, ImGuiKey_PageUp},
    {Key::page_down, ImGuiKey_PageDown},
    {Key::tab, ImGuiKey_Tab},
    {Key::enter, ImGuiKey_Enter},
    {Key::escape, ImGuiKey_Escape},
    {Key::a, ImGuiKey_A},
    {Key::c, ImGuiKey_C},
    {Key::v, ImGuiKey_V},
    {Key::x, ImGuiKey_X},
    {Key::z, ImGuiKey_Z},
#if IMGUI_VERSION_NUM >= 18700
    {Key::f, ImGuiKey_F},
    {Key::p, ImGuiKey_P},
    {Key::q, ImGuiKey_Q},
    {Key::o, ImGuiKey_O},
    {Key::s, ImGuiKey_S},
    {Key::b, ImGuiKey_B},
    {Key::r, ImGuiKey_R},
    {Key::t, ImGuiKey_T},
    {Key::y, ImGuiKey_Y},
    {Key::j, ImGuiKey_J},
    {Key::l, ImGuiKey_L},
    {Key::n, ImGuiKey_N},
    {Key::zero, ImGuiKey_0},
    {Key::equal, ImGuiKey_Equal},
    {Key::minus, ImGuiKey_Minus},
    {Key::bracket_left, ImGuiKey_LeftBracket},
    {Key::bracket_right, ImGuiKey_RightBracket},
    {Key::f1, ImGuiKey_F1},
    {Key::f11, ImGuiKey_F11},
    {Key::f6, ImGuiKey_F6},
#endif
};

#if IMGUI_VERSION_NUM >= 18700

ImGuiKey imgui_key(Key key) {
    const auto* found = std::find_if(std::begin(editing_keys), std::end(editing_keys),
                                     [&](const KeyName& name) { return name.key == key; });
    return found == std::end(editing_keys) ? ImGuiKey_None : found->imgui;
}

// What goes from widget to widget are the buttons of a gamepad: the keyboard's own way would take keys from the run.
constexpr KeyName steering_keys[] = {{Key::up, ImGuiKey_GamepadDpadUp},       {Key::down, ImGuiKey_GamepadDpadDown},
                                     {Key::left, ImGuiKey_GamepadDpadLeft},   {Key::right, ImGuiKey_GamepadDpadRight},
                                     {Key::enter, ImGuiKey_GamepadFaceDown},  {Key::space, ImGuiKey_GamepadFaceDown},
                                     {Key::escape, ImGuiKey_GamepadFaceRight}};

void set_key(ImGuiIO& io, Key key, bool down) {
    io.AddKeyEvent(imgui_key(key), down);
    for (const KeyName& name : steering_keys) {
        if (name.key == key) io.AddKeyEvent(name.imgui, down);
    }
}
void fill_steering(ImGuiIO&) {}
bool key_pressed(Key key, bool repeat) { return ImGui::IsKeyPressed(imgui_key(key), repeat); }
void set_pointer(ImGuiIO& io, ImVec2 place) { io.AddMousePosEvent(place.x, place.y); }
void set_button(ImGuiIO& io, int button, bool down) { io.AddMouseButtonEvent(button, down); }
void add_wheel(ImGuiIO& io, float lines) { io.AddMouseWheelEvent(0, lines); }
void set_modifiers(ImGuiIO& io, const ModifiersChanged& now) {
    io.AddKeyEvent(ImGuiMod_Ctrl, now.control);
    io.AddKeyEvent(ImGuiMod_Shift, now.shift);
    io.AddKeyEvent(ImGuiMod_Alt, now.alt);
}
void release_all(ImGuiIO& io) { io.AddFocusEvent(false); }

#else

struct SteeringKey {
    Key key;
    ImGuiNavInput_ input;
};
// What goes from widget to widget are the buttons of a gamepad: the keyboard's own way would take keys from the run.
constexpr SteeringKey steering_keys[] = {{Key::up, ImGuiNavInput_DpadUp},      {Key::down, ImGuiNavInput_DpadDown},
                                         {Key::left, ImGuiNavInput_DpadLeft},  {Key::right, ImGuiNavInput_DpadRight},
                                         {Key::enter, ImGuiNavInput_Activate}, {Key::space, ImGuiNavInput_Activate},
                                         {Key::escape, ImGuiNavInput_Cancel}};

bool is_arrow(Key key) { return key == Key::up || key == Key::down || key == Key::left || key == Key::right; }

/// A press lasts for one frame, however slow that is; a held arrow is pressed again and again.
bool steers(const ImGuiIO& io, Key key) {
    const auto number = static_cast<int>(key);
    if (!io.KeysDown[number]) return false;
    const float held = io.KeysDownDuration[number];
    if (held < 0) return true;
    return is_arrow(key) &&
           ImGui::CalcTypematicRepeatAmount(held, held + io.DeltaTime, io.KeyRepeatDelay, io.KeyRepeatRate) > 0;
}

void fill_steering(ImGuiIO& io) {
    for (const SteeringKey& each : steering_keys) {
        if (steers(io, each.key)) io.NavInputs[each.input] = 1;
    }
}

void set_key(ImGuiIO& io, Key key, bool down) { io.KeysDown[static_cast<int>(key)] = down; }
bool key_pressed(Key key, bool repeat) { return ImGui::IsKeyPressed(static_cast<int>(key), repeat); }
void set_pointer(ImGuiIO& io, ImVec2 place) { io.MousePos = place; }
void set_button(ImGuiIO& io, int button, bool down) { io.MouseDown[button] = down; }
void add_wheel(ImGuiIO& io, float lines) { io.MouseWheel += lines; }
void set_modifiers(ImGuiIO& io, const ModifiersChanged& now) {
    io.KeyCtrl = now.control;
    io.KeyShift = now.shift;
    io.KeyAlt = now.alt;
}
void release_all(ImGuiIO& io) {
    std::fill(std::begin(io.KeysDown), std::end(io.KeysDown), false);
    std::fill(std::begin(io.MouseDown), std::end(io.MouseDown), false);
    set_modifiers(io, {});
}

#endif

/// Passes one event to ImGui; true if it is a press or a release.
struct Feed {
    ImGuiIO& io;

    bool operator()(const PointerMoved& e) const { return set_pointer(io, {e.x, e.y}), false; }
    bool operator()(const ButtonChanged& e) const { return set_button(io, e.button, e.down), true; }
    bool operator()(const WheelTurned& e) const { return add_wheel(io, e.lines), false; }
    bool operator()(const KeyChanged& e) const { return set_key(io, e.key, e.down), true; }
    bool operator()(const ModifiersChanged& e) const { return set_modifiers(io, e), false; }
    bool operator()(const TextTyped& e) const { return io.AddInputCharacter(e.character), false; }
    bool operator()(const FocusLost&) const { return release_all(io), true; }
};

}  // namespace

void Input::describe_keys(ImGuiIO& io) {
#if IMGUI_VERSION_NUM >= 18700
    (void)io;
#else
    for (const KeyName& name : editing_keys) io.KeyMap[name.imgui] = static_cast<int>(name.key);
#endif
}

bool Input::feed(ImGuiIO& io) {
    bool frame_is_full = false;
    bool moved = false;
    while (!events_.empty() && !frame_is_full && !ends_a_drag(events_.front(), moved)) {
        moved = moved || std::holds_alternative<PointerMoved>(events_.front());
        frame_is_full = std::visit(Feed{io}, events_.front());
        events_.pop_front();
    }
    return !events_.empty();
}

/// ImGui does not see a drag in the same frame as the release of the button.
bool Input::ends_a_drag(const InputEvent& event, bool moved) {
    const auto* button = std::get_if<ButtonChanged>(&event);
    return moved && button && !button->down;
}

void Input::steer(ImGuiIO& io, bool on) {
    io.ConfigFlags &= ~ImGuiConfigFlags_NavEnableGamepad;
    if (!on) return;
    io.ConfigFlags |= ImGuiConfigFlags_NavEnableGamepad;
    fill_steering(io);
}

bool Input::pressed(Key key, bool repeat) { return key_pressed(key, repeat); }

int presses(Key positive, Key negative) { return Input::pressed(positive, true) - Input::pressed(negative, true); }

PointerAway::PointerAway(ImGuiIO& io) : io_(io), place_(io.MousePos) { set_pointer(io, {-FLT_MAX, -FLT_MAX}); }

PointerAway::~PointerAway() { set_pointer(io_, place_); }

}  // namespace steplab::ui
