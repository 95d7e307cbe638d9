#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace steplab::ui {

/// What a key or a button does.
enum class Action {
    pause,
    step_forward,
    step_back,
    restart,
    reset_view,
    frame_all,
    faster,
    slower,
    scene_before,
    scene_after,
    panel,
    help,
    picture,
    full_screen,
    quit
};

/// The keys the interface knows, whatever library they come from; the others are none of its business.
enum class Key {
    none,
    space,
    left,
    right,
    backspace,
    home,
    end,
    del,
    f,
    equal,
    minus,
    bracket_left,
    bracket_right,
    tab,
    f1,
    f11,
    p,
    q,
    enter,
    escape,
    up,
    down,
    a,
    c,
    v,
    x,
    z,
    count
};

/// One line of the table of keys: help, tooltips and documentation are made from it.
struct KeyBinding {
    Action action;
    Key key;
    bool control = false;
    std::string_view label;  ///< "Ctrl+P"
    std::string_view what;   ///< "save a picture"
};

/// What the mouse does over the scene.
struct MouseBinding {
    std::string_view label;
    std::string_view what;
};

std::span<const KeyBinding> key_bindings();
std::span<const MouseBinding> mouse_bindings();

/// The binding of an action. Every action has one.
const KeyBinding& binding_of(Action action);

/// The table for the documentation, in Markdown.
std::string key_table();

}  // namespace steplab::ui
