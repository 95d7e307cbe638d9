#pragma once

#include <optional>
#include <string>

namespace CLI {
class App;
}

namespace steplab {

/// The window's options on the command line, beside the scene's.
struct WindowRequest {
    int width = 1280;  ///< pixels
    int height = 800;
    std::optional<float> scale;  ///< pixels per unit of the layout; none: the display's
    std::string view;            ///< camera as text; empty: the scene's own
    std::string trace;           ///< file to which events are written; empty: none
    bool full_screen = false;
    bool playing = false;
};

/// The options of `steplab view` and `steplab-view` that are not the scene's.
class ViewOptions {
public:
    void declare(CLI::App& app);
    /// Throws UsageError for values of another form or out of range.
    WindowRequest request() const;

private:
    std::string size_ = "1280x800";
    std::string scale_;
    std::string view_;
    std::string trace_;
    bool full_screen_ = false;
    bool playing_ = false;
};

}  // namespace steplab
