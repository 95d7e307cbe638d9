#pragma once

#include "sim/run/worker.hpp"
#include "ui/context.hpp"
#include "ui/display.hpp"
#include "ui/input.hpp"

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

struct ImDrawData;
struct ImFontAtlas;
struct ImGuiContext;

namespace steplab::ui {

/// The clipboard that other programs see.
struct Clipboard {
    std::function<std::string()> read;
    std::function<void(const std::string& text)> write;
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
    /// A new moment of the run: to be called once for each, before it is drawn.
    void record(const RunView& view);
    /// The OpenGL name of the texture that holds the newest picture of the scene, top row first: it is part of the
    /// draw data from now on. 0: the scene is drawn by other means.
    void show_scene(std::uint32_t texture);

    /// Keyboard and mouse: what is pushed here is fed to the next frames.
    Input& input();
    /// What is cut, copied and pasted in text entries goes by this clipboard; without one it stays in the interface.
    void use_clipboard(Clipboard clipboard);
    /// One frame: sends what the person asked for to `commands`, moves the camera and sets the style.
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
    /// How long the picture stays as it is if nothing happens, in seconds: 0 where another frame is wanted at once.
    double seconds_until_change() const;
    /// Shows `text` for a while over the scene: a picture was saved, a command was copied.
    void notify(std::string text);
    /// Shows a message that stays until it is closed: what could not be done, and why.
    void complain(std::string text);
    /// Where each widget of the last frame was drawn, by name; for tests.
    const WidgetMap& widgets() const;

private:
    struct Body;
    void draw_frame(const RunView& view, Commands& commands, Stage stage, const Measured& measured, bool still);

    std::unique_ptr<Body> body_;
};

}  // namespace steplab::ui
