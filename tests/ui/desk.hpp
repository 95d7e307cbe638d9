#pragma once

#include "ui/interface.hpp"
#include "ui/recorder.hpp"

#include <string>
#include <string_view>

namespace steplab::ui {

/// An interface without a window, and a hand that uses it: ImGui runs with its font atlas and draws into nothing.
class Desk {
public:
    explicit Desk(const RunDescription& description = describe(), const Display& display = {1280, 1200, 1});
    Desk(const Desk&) = delete;
    Desk& operator=(const Desk&) = delete;

    /// One frame with the input that is set.
    void frame();
    /// The frames of a picture of the window.
    void picture();
    /// Of a plot alone: its place.
    WidgetRect plot_picture(const std::string& plot);
    /// Another view of the run, recorded as the newest.
    void show(const RunView& newer);
    /// Where a widget is; fails the test, naming those there are, if it is not drawn.
    WidgetRect widget(std::string_view name);
    bool has(std::string_view name) const { return interface.widgets().contains(name); }
    /// How many vertices were drawn inside a place.
    int vertices_within(const WidgetRect& place) const;

    void move_to(float x, float y);
    /// Moves onto a widget, `part` of its width from the left.
    void point_at(std::string_view name, float part = 0.5f);
    void press(int button = 0);
    void release(int button = 0);
    /// Presses and releases over a widget, with a frame between.
    void click(std::string_view name, float part = 0.5f);
    void double_click(std::string_view name);
    void click_with_control(std::string_view name);
    /// From one part of a widget to another with the left button down.
    void drag(std::string_view name, float from, float to);
    void key(Key key, bool control = false, bool shift = false);
    void type(std::string_view text);
    void wheel(float lines);

    /// The events that came since the last call of this.
    std::vector<std::string> calls();
    /// The description asked for last.
    const RunDescription& wanted() const { return recorder.changes.back(); }

    SessionView session;
    RunView& view = session.leading;
    Recorder recorder;
    render::Camera camera;
    render::Style style;
    Interface interface;
};

}  // namespace steplab::ui
