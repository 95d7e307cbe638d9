#include "ui/keys.hpp"

#include <algorithm>
#include <array>

namespace steplab::ui {
namespace {

constexpr std::array<KeyBinding, 33> keys = {{
    {Action::pause, Key::space, false, "Space", "play or pause"},
    {Action::play_back, Key::j, false, "J", "play backwards, or pause"},
    {Action::loop, Key::l, false, "L", "repeat between the marks around this moment, or all"},
    {Action::step_forward, Key::right, false, "Right", "one step forward"},
    {Action::step_back, Key::left, false, "Left", "one step back"},
    {Action::restart, Key::backspace, false, "Backspace", "restart the run"},
    {Action::undo, Key::z, true, "Ctrl+Z", "undo the last change"},
    {Action::redo, Key::y, true, "Ctrl+Y", "redo what was undone"},
    {Action::bookmark, Key::b, false, "B", "mark the moment, or remove its mark"},
    {Action::turn_round, Key::r, false, "R", "turn all velocities round: time runs back"},
    {Action::twin, Key::t, false, "T", "float beside double, or without it again"},
    {Action::select_box, Key::s, false, "S", "select the particles in a box: drag it next"},
    {Action::next_particle, Key::n, false, "N", "select the next particle"},
    {Action::previous_particle, Key::p, false, "P", "select the particle before"},
    {Action::reset_view, Key::home, false, "Home", "reset the view"},
    {Action::zoom_to_fit, Key::f, false, "F", "zoom to fit"},
    {Action::faster, Key::equal, false, "=", "play faster"},
    {Action::slower, Key::minus, false, "-", "play slower"},
    {Action::previous_scene, Key::bracket_left, false, "[", "previous scene"},
    {Action::next_scene, Key::bracket_right, false, "]", "next scene"},
    {Action::open_scene, Key::o, true, "Ctrl+O", "choose or open a scene"},
    {Action::save_scene, Key::s, true, "Ctrl+S", "save the scene as a file"},
    {Action::panel, Key::tab, false, "Tab", "show or hide the panel"},
    {Action::larger, Key::equal, true, "Ctrl+=", "larger text and panels"},
    {Action::smaller, Key::minus, true, "Ctrl+-", "smaller text and panels"},
    {Action::usual_scale, Key::zero, true, "Ctrl+0", "text and panels of the usual size"},
    {Action::steer, Key::f6, false, "F6", "panels by keyboard, the next one: arrows, Enter, Esc"},
    {Action::help, Key::f1, false, "F1", "help"},
    {Action::snapshot, Key::p, true, "Ctrl+P", "save a snapshot"},
    {Action::record, Key::r, true, "Ctrl+R", "record a film, or end it"},
    {Action::full_screen, Key::f11, false, "F11", "full screen"},
    {Action::close, Key::escape, false, "Esc", "close the menu or the message on top"},
    {Action::quit, Key::q, true, "Ctrl+Q", "quit"},
}};

constexpr std::array<MouseBinding, 19> gestures = {{
    {"= - [ ] Home at a plot, after F6", "zoom the axis across, move along it, show all; with Shift, the axis up"},
    {"arrows, Enter at speed against error, after F6", "go from point to point, add the run of one"},
    {"Alt + arrows", "orbit; with Shift, pan"},
    {"Alt + = -", "zoom"},
    {"Ctrl + arrows", "pull the selected particle until Ctrl is let go; with Shift, by larger steps"},
    {"Shift + arrows", "panel wider or narrower, plots higher or lower; Shift + Home: usual sizes"},
    {"Page Up, Page Down", "scroll the panel, a lesson, the scenes or this help"},
    {"left drag", "orbit"},
    {"right drag, Shift + left drag", "pan"},
    {"wheel", "zoom towards the pointer"},
    {"click", "select a particle"},
    {"Shift + click", "add a particle to the selected ones, or remove it"},
    {"Alt + left drag", "select the particles in a box; with Shift, add them"},
    {"Ctrl + left drag", "pull a particle; while the run plays, by a spring"},
    {"Ctrl + right drag", "kick a particle: the arrow is its way in a second"},
    {"double click on a slider", "reset it to its default"},
    {"Ctrl + click on a slider, click on its value", "type an exact value"},
    {"wheel, left drag on a plot", "zoom into time, move along it; double click: all of it"},
    {"right click on a plot", "save it as CSV, SVG or PNG"},
}};

template <class Rows>
void append_rows(std::string& table, const Rows& rows) {
    for (const auto& row : rows) {
        table.append("| ").append(row.label).append(" | ").append(row.what).append(" |\n");
    }
}

}  // namespace

std::span<const KeyBinding> key_bindings() { return keys; }

std::span<const MouseBinding> mouse_bindings() { return gestures; }

const KeyBinding& binding_of(Action action) {
    return *std::find_if(keys.begin(), keys.end(), [&](const KeyBinding& binding) { return binding.action == action; });
}

std::string key_table() {
    std::string table = "| key or mouse | action |\n|---|---|\n";
    append_rows(table, keys);
    append_rows(table, gestures);
    return table;
}

}  // namespace steplab::ui
