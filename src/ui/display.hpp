#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>

namespace steplab::ui {

/// The surface that the interface is drawn on.
struct Display {
    int width = 1280;  ///< pixels
    int height = 720;
    float scale = 1;  ///< pixels per unit of the layout: 2 on a display of twice the usual density
    friend bool operator==(const Display&, const Display&) = default;
};

/// A rectangle in pixels from the top left of the display.
struct PixelRect {
    int x = 0;
    int y = 0;
    int width = 0;
    int height = 0;
    friend bool operator==(const PixelRect&, const PixelRect&) = default;
};

/// What a frame of the interface is drawn for.
enum class Purpose {
    use,            ///< the window
    still,          ///< a picture drawn without a window
    scene_still,    ///< the same of the scene alone
    window_picture  ///< a picture of the window, without pointer, notice and menu
};

/// Times measured by a running window. A snapshot shows none of them.
struct Measured {
    std::optional<double> frame_seconds = {};  ///< it took to draw the last picture of the scene
    double since_last_frame = 1.0 / 60;        ///< seconds since the interface was last drawn
};

/// A film that is being taken.
struct FilmStatus {
    std::uint64_t frames = 0;
    double seconds = 0;  ///< how long it plays
};

/// A request that the program carries out, not the interface.
struct Request {
    enum class Kind {
        save_snapshot,
        record,
        copy_text,
        open_page,
        open_scene,
        open_lesson,
        save_scene,
        save_session,
        full_screen,
        quit
    };
    Kind kind = Kind::quit;
    std::string text = {};  ///< copy_text: the text for the clipboard; open_scene: a path, or the name of a shipped
                            ///< scene; open_lesson: the name of a shipped lesson; open_page: that of a page of docs/
    std::string file = {};  ///< save_snapshot: path; empty: a new name
    std::string plot = {};  ///< save_snapshot: the name of a plot; empty: what was chosen for pictures
};

/// Where a widget was drawn, in pixels of the display. Tests find widgets by name.
struct WidgetRect {
    float left = 0;
    float top = 0;
    float right = 0;
    float bottom = 0;
    friend bool operator==(const WidgetRect&, const WidgetRect&) = default;
};
using WidgetMap = std::map<std::string, WidgetRect, std::less<>>;

}  // namespace steplab::ui
