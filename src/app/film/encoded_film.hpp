#pragma once

#include "app/film/film.hpp"
#include "io/child_program.hpp"
#include "io/output_file.hpp"

#include <optional>

namespace steplab {

/// A kind of film that ffmpeg encodes.
struct Encoding {
    std::string_view ending;
    std::string_view muxer;
    std::vector<std::string> options;  ///< of ffmpeg
    bool even_sides = false;           ///< it allows no others
    double most_fps = 1000;
};

/// That of a file's name; null for another one.
const Encoding* encoding_of(std::string_view name);

/// A film that ffmpeg encodes and writes into an OutputFile: into the open file, so that it makes no other one under
/// the hidden name where this program has ended before. Its memory does not grow with the number of pictures.
class EncodedFilm final : public Film {
public:
    EncodedFilm(const FilmFormat& format, const Encoding& encoding);

    void add(const Picture& picture, bool repeated) override;
    void finish() override;
    std::string keep() override;

private:
    [[noreturn]] void fail();

    OutputFile file_;
    std::optional<ChildProgram> ffmpeg_;  ///< none once it was given up
};

}  // namespace steplab
