#pragma once

#include "app/commands/picture_options.hpp"
#include "app/film/film.hpp"

#include <string>

namespace steplab {

/// The options of `record` for the film and its pictures.
class FilmOptions {
public:
    void declare(CLI::App& app);
    /// What is drawn, without its run. Throws UsageError for values of another form or out of range.
    PictureRequest request(const RunDescription& description, std::size_t particles = 0) const;
    /// The file or files, for pictures of this size. Throws UsageError.
    FilmFormat format(render::PictureSize size) const;
    /// Simulated time from one picture to the next, > 0. Throws UsageError.
    double spacing() const;

    const std::string& out() const { return out_; }
    const std::string& gl() const { return picture_.gl(); }
    const std::string& size_text() const { return picture_.size_text(); }

private:
    double fps() const;

    std::string out_;
    std::string fps_ = "30";
    std::string speed_ = "1";
    PictureOptions picture_;
};

}  // namespace steplab
