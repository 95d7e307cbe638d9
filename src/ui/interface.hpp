#pragma once

#include "render/camera.hpp"
#include "render/style.hpp"
#include "sim/worker.hpp"
#include "ui/display.hpp"
#include "ui/history.hpp"

#include <memory>
#include <optional>
#include <string>
#include <vector>

struct ImDrawData;
struct ImFontAtlas;
struct ImGuiContext;

namespace steplab::ui {

/// What of the drawing the interface reads and changes.
struct Stage {
    render::Camera& camera;
    render::Style& style;
};

/// The whole panel set of one window or still picture. It owns an ImGui context and no OpenGL object: whoever draws
/// takes draw_data() and fonts(). All positions are pixels from the top left of the display.
///
/// A still picture (`snapshot --ui on`):
///     ui::Interface interface({.width = 1280, .height = 720});
///     for (const RunView& earlier : recorded) interface.record(earlier);   // plots; may be none
///     interface.draw_still(view_of(simulation), {camera, style});
///     // draw the scene into interface.scene(), then interface.draw_data() over the whole picture
class Interface {
public:
    explicit Interface(const Display& display);
    ~Interface();
    Interface(const Interface&) = delete;
    Interface& operator=(const Interface&) = delete;

    /// The display's size or scale changed; true if the fonts were built anew, so that their texture must be too.
    bool resize(const Display& display);
    /// Takes a moment of the run into the plots.
    void record(const RunView& view);

    /// One frame: reads the input that was set on the ImGui context, sends what the person asked for to `commands`,
    /// moves the camera and sets the style. `measured` is left out of still pictures.
    void draw(const RunView& view, Commands& commands, Stage stage, const Measured& measured = {});
    /// The frame of a picture that nobody touches: the same view gives the same draw data, whenever it is drawn.
    void draw_still(const RunView& view, Stage stage);

    /// Where the scene is to be drawn; of the frame drawn last.
    PixelRect scene() const;
    /// Of the frame drawn last; valid until the next one.
    ImDrawData& draw_data() const;
    ImFontAtlas& fonts() const;
    ImGuiContext& context() const;

    /// What was asked for since the last call that is the program's to do.
    std::vector<Request> take_requests();
    /// True while something on the screen still changes by itself (a closing menu, a hover), so one more frame is
    /// wanted.
    bool wants_another_frame() const;
    /// Shows `text` for a while over the scene: a picture was saved, a command was copied.
    void notify(std::string text);
    /// Where each widget of the last frame was drawn, by name; for tests.
    const WidgetMap& widgets() const;

private:
    struct Body;
    std::unique_ptr<Body> body_;
};

}  // namespace steplab::ui
