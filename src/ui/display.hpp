#pragma once

#include <map>
#include <optional>
#include <string>

namespace steplab::ui {

/// The surface the interface is drawn on.
struct Display {
    int width = 1280;  ///< pixels
    int height = 720;
    float scale = 1;  ///< pixels of one unit of the layout: 2 on a display of twice the usual density
    friend bool operator==(const Display&, const Display&) = default;
};

/// Pixels from the top left of the display.
struct PixelRect {
    int x = 0;
    int y = 0;
    int width = 0;
    int height = 0;
    friend bool operator==(const PixelRect&, const PixelRect&) = default;
};

/// What only a running window knows; nothing of it is in a still picture.
struct Measured {
    std::optional<double> frame_seconds = {};  ///< time it took to draw the last picture of the scene
    double since_last_frame = 1.0 / 60;        ///< seconds since the interface was drawn last
};

/// Something the program does rather than the interface.
struct Request {
    enum class Kind { save_picture, copy_text, full_screen, quit };
    Kind kind = Kind::quit;
    std::string text = {};  ///< copy_text: what to put on the clipboard
    std::string file = {};  ///< save_picture: where to
    PixelRect part = {};    ///< save_picture: the part of the window; nothing of it (width 0) means all
};

/// Where a widget was drawn, and by its name a test finds it.
struct WidgetRect {
    float left = 0;
    float top = 0;
    float right = 0;
    float bottom = 0;
    friend bool operator==(const WidgetRect&, const WidgetRect&) = default;
};
using WidgetMap = std::map<std::string, WidgetRect, std::less<>>;

}  // namespace steplab::ui
