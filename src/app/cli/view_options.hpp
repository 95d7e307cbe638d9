#pragma once

#include <optional>
#include <string>

namespace CLI {
class App;
}

namespace steplab {

/// The window as a person asks for it on the command line, beside the scene.
struct WindowRequest {
    int width = 1280;  ///< pixels
    int height = 800;
    std::optional<float> scale;  ///< pixels of a unit of the layout; none: as the display says
    std::string view;            ///< camera as text; empty: where the scene opens
    std::string trace;           ///< file that is told what happens; empty: none
    bool full_screen = false;
    bool playing = false;
};

/// The options of `steplab view` and `steplab-view` that are not the scene's.
class ViewOptions {
public:
    void declare(CLI::App& app);
    /// Throws UsageError for values that cannot be meant.
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
