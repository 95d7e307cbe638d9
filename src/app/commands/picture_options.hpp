#pragma once

#include "app/cli/appearance_options.hpp"
#include "app/cli/picture_content_options.hpp"
#include "app/offscreen/modules.hpp"

#include <string>

namespace CLI {
class App;
}

namespace steplab {

/// The heading of a picture's options in the help.
inline constexpr const char* picture_group = "Picture";

/// The options of a picture, the same for snapshots and films: its size, how the scene is shown, and the OpenGL
/// context.
class PictureOptions {
public:
    void declare(CLI::App& app);
    /// The picture to draw, without its run. Throws UsageError for values of another form or out of range.
    PictureRequest request(const RunDescription& description, std::size_t particles = 0) const;

    const std::string& gl() const { return gl_; }
    const std::string& size_text() const { return size_; }

private:
    std::string size_ = "1280x720";
    std::string gl_ = "auto";
    AppearanceOptions appearance_;
    PictureContentOptions shown_;
};

}  // namespace steplab
