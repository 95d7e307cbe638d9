#include "ui/desk.hpp"

#include <gtest/gtest.h>

namespace steplab::ui {

Desk::Desk(const RunDescription& description, const Display& display) : interface(display) {
    view = view_of(Simulation(description));
    interface.record(view);
    move_to(-100, -100);
    frame();
    frame();
    recorder = {};
}

void Desk::frame() { interface.draw(session, recorder, {camera, style}); }

void Desk::picture() { interface.draw_picture(session, {camera, style}); }

WidgetRect Desk::plot_picture(const std::string& plot) {
    const PixelRect place = interface.draw_plot_picture(session, {camera, style}, plot);
    const auto x = static_cast<float>(place.x), y = static_cast<float>(place.y);
    return {x, y, x + static_cast<float>(place.width), y + static_cast<float>(place.height)};
}

void Desk::show(const RunView& newer) {
    view = newer;
    interface.record(view);
    frame();
}

WidgetRect Desk::widget(std::string_view name) {
    const auto found = interface.widgets().find(name);
    if (found != interface.widgets().end()) return found->second;
    std::string known;
    for (const auto& [widget, place] : interface.widgets()) known.append(widget).append(", ");
    ADD_FAILURE() << "no widget '" << name << "' among " << known;
    return {};
}

int Desk::vertices_within(const WidgetRect& place) const {
    int count = 0;
    const ImDrawData& data = interface.draw_data();
    for (int i = 0; i < data.CmdListsCount; ++i)
        for (const ImDrawVert& vertex : data.CmdLists[i]->VtxBuffer)
            if (vertex.pos.x > place.left && vertex.pos.x < place.right && vertex.pos.y > place.top &&
                vertex.pos.y < place.bottom)
                ++count;
    return count;
}

void Desk::move_to(float x, float y) {
    interface.input().push(PointerMoved{x, y});
    frame();
}

void Desk::point_at(std::string_view name, float part) {
    const WidgetRect place = widget(name);
    move_to(place.left + part * (place.right - place.left), 0.5f * (place.top + place.bottom));
}

void Desk::press(int button) {
    interface.input().push(ButtonChanged{button, true});
    frame();
}

void Desk::release(int button) {
    interface.input().push(ButtonChanged{button, false});
    frame();
}

void Desk::click(std::string_view name, float part) {
    point_at(name, part);
    press();
    release();
    // What a click opens is drawn one frame later, and takes the keyboard in the frame after that.
    for (int i = 0; i < 3; ++i) frame();
}

void Desk::double_click(std::string_view name) {
    point_at(name);
    for (int i = 0; i < 2; ++i) {
        press();
        release();
    }
}

void Desk::click_with_control(std::string_view name) {
    interface.input().push(ModifiersChanged{.control = true});
    click(name);
    interface.input().push(ModifiersChanged{});
    frame();
    frame();
}

void Desk::drag(std::string_view name, float from, float to) {
    point_at(name, from);
    press();
    point_at(name, to);
    release();
}

void Desk::key(Key key, bool control, bool shift) {
    interface.input().push(ModifiersChanged{.control = control, .shift = shift});
    interface.input().push(KeyChanged{key, true});
    frame();
    interface.input().push(KeyChanged{key, false});
    interface.input().push(ModifiersChanged{});
    frame();
    frame();
}

void Desk::type(std::string_view text) {
    for (const char c : text) interface.input().push(TextTyped{static_cast<unsigned char>(c)});
    frame();
}

void Desk::wheel(float lines) {
    interface.input().push(WheelTurned{lines});
    frame();
}

std::vector<std::string> Desk::calls() { return std::exchange(recorder.calls, {}); }

}  // namespace steplab::ui
