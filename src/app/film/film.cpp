#include "app/film/film.hpp"

#include "app/film/encoded_film.hpp"
#include "app/film/series_name.hpp"
#include "app/png.hpp"
#include "core/error.hpp"
#include "core/number_text.hpp"
#include "core/shown.hpp"
#include "io/output_file.hpp"

#include <fmt/format.h>

#include <cstdint>

namespace steplab {
namespace {

/// A file for each picture, numbered from 0: picture k of k * speed / fps.
class PictureSeries final : public Film {
public:
    explicit PictureSeries(const FilmFormat& format) : name_(format.name) {}

    void add(const Picture& picture, bool repeated) override {
        if (!repeated) bytes_ = encode_png(picture.size.width, picture.size.height, picture.rgba);
        OutputFile file(name_.of(written_));
        file.write(bytes_);
        file.commit();
        ++written_;
    }
    void finish() override {}
    std::string keep() override {
        return written_ == 1 ? "the picture so far is kept" : fmt::format("the {} pictures so far are kept", written_);
    }

private:
    SeriesName name_;
    std::string bytes_;  ///< of the last picture
    std::uint64_t written_ = 0;
};

void check_encoded(const FilmFormat& format, const Encoding& encoding) {
    const auto [width, height] = format.size;
    if (encoding.even_sides && (width % 2 != 0 || height % 2 != 0)) {
        throw UsageError(
            fmt::format("--size {}x{}: the sides of a film in {} are even numbers", width, height, encoding.ending));
    }
    if (format.fps > encoding.most_fps) {
        throw UsageError(fmt::format("--fps {}: a film in {} has at most {} frames per second", exact_text(format.fps),
                                     encoding.ending, exact_text(encoding.most_fps)));
    }
    if (written_directly(format.name)) {
        throw UsageError(fmt::format("--out: '{}' is no file, which a film needs", shown(format.name)));
    }
}

}  // namespace

void check_film(const FilmFormat& format) {
    if (format.name.empty())
        throw UsageError("--out FILE is required: film.mp4, film.webm, film.gif or frames/%05d.png");
    if (const Encoding* encoding = encoding_of(format.name)) return check_encoded(format, *encoding);
    if (format.name.ends_with(".png")) return static_cast<void>(SeriesName(format.name));
    throw UsageError(fmt::format("--out must end in .mp4, .webm or .gif, or in .png as frames/%05d.png (got \"{}\")",
                                 shown(format.name)));
}

std::unique_ptr<Film> make_film(const FilmFormat& format) {
    check_film(format);
    if (const Encoding* encoding = encoding_of(format.name)) return std::make_unique<EncodedFilm>(format, *encoding);
    return std::make_unique<PictureSeries>(format);
}

}  // namespace steplab
