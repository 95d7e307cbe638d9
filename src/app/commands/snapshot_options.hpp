#pragma once

#include "app/offscreen/modules.hpp"

#include <string>

namespace CLI {
class App;
}

namespace steplab {

/// The options of `snapshot` for the picture and its file.
class SnapshotOptions {
public:
    void declare(CLI::App& app);
    /// The picture to draw, without its run. Throws UsageError for values of another form or out of range.
    PictureRequest request(const RunDescription& description) const;

    const std::string& out() const { return out_; }
    const std::string& gl() const { return gl_; }
    const std::string& size_text() const { return size_; }

private:
    std::string out_;
    std::string size_ = "1280x720";
    std::string view_ = "default";
    std::string panel_ = "off";
    std::string gl_ = "auto";
    std::string colour_ = "role";
    std::string background_ = "dark";
    std::string particle_;
    std::string scale_;
};

}  // namespace steplab
