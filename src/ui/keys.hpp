#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace steplab::ui {

/// What a key or a button does to the run, the view or the window.
enum class Action {
    pause,
    play_back,
    loop,
    step_forward,
    step_back,
    restart,
    undo,
    redo,
    bookmark,
    turn_round,
    twin,
    select_box,
    next_particle,
    previous_particle,
    reset_view,
    zoom_to_fit,
    faster,
    slower,
    previous_scene,
    next_scene,
    open_scene,
    save_scene,
    panel,
    larger,
    smaller,
    usual_scale,
    help,
    snapshot,
    record,
    steer,
    full_screen,
    close,
    quit
};

/// The keys of the interface, independent of the window library; all other keys are ignored.
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
    o,
    s,
    b,
    r,
    t,
    y,
    j,
    l,
    zero,
    f6,
    page_up,
    page_down,
    n,
    count
};

/// A row of the table of keys. Help, tooltips and documentation are generated from the table.
struct KeyBinding {
    Action action;
    Key key;
    bool control = false;
    std::string_view label;  ///< "Ctrl+P"
    std::string_view what;   ///< "save a snapshot"
};

/// A row of the table of mouse actions, and of keys that mean something else where the keyboard is in a plot.
struct MouseBinding {
    std::string_view label;
    std::string_view what;
};

std::span<const KeyBinding> key_bindings();
std::span<const MouseBinding> mouse_bindings();

/// The binding of an action. Every action has one.
const KeyBinding& binding_of(Action action);

/// Both tables for the documentation, in Markdown.
std::string key_table();

}  // namespace steplab::ui
