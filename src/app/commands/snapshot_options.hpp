#pragma once

#include "app/commands/picture_options.hpp"

#include <string>

namespace steplab {

/// The options of `snapshot` for the picture and its file.
class SnapshotOptions {
public:
    void declare(CLI::App& app);
    /// The picture to draw, without its run. Throws UsageError for values of another form or out of range.
    PictureRequest request(const RunDescription& description, std::size_t particles = 0) const;

    const std::string& out() const { return out_; }
    const std::string& gl() const { return picture_.gl(); }
    const std::string& size_text() const { return picture_.size_text(); }

private:
    std::string out_;
    PictureOptions picture_;
};

}  // namespace steplab
