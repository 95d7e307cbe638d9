#pragma once

#include "app/offscreen/module.hpp"

#include <memory>
#include <string>
#include <string_view>

namespace steplab {

/// The file or files of a film that is being written. Without finish() (an exception) no film is left, but what keep()
/// keeps.
class Film {
public:
    virtual ~Film() = default;
    Film() = default;
    Film(const Film&) = delete;
    Film& operator=(const Film&) = delete;

    /// The next picture; `repeated`: it is that before. Throws FileError, Interrupted.
    virtual void add(const Picture& picture, bool repeated) = 0;
    /// All pictures are there. Throws FileError, Interrupted.
    virtual void finish() = 0;
    /// Gives it up after an interruption or a failure: keeps what there is of it, and says so in a message.
    virtual std::string keep() = 0;
};

/// What a film needs to know of its pictures.
struct FilmFormat {
    std::string name;  ///< of the file, or of the series of files
    render::PictureSize size;
    double fps = 30;
};

/// The film that the ending of its name says: MP4, WebM and GIF are written by ffmpeg's program. Throws UsageError for
/// another name and for what the format does not allow, FileError if it cannot be written, as where there is no ffmpeg.
std::unique_ptr<Film> make_film(const FilmFormat& format);

/// Throws UsageError as make_film() does, without beginning anything.
void check_film(const FilmFormat& format);

}  // namespace steplab
