#include "app/film/encoded_film.hpp"

#include "core/error.hpp"
#include "core/interruption.hpp"
#include "core/number_text.hpp"
#include "core/shown.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

namespace steplab {
namespace {

// Players take the colours of a film without a note to be those of HDTV.
constexpr const char* colours = "scale=out_color_matrix=bt709:out_range=tv,format=yuv420p";

std::vector<std::string> with_colours(std::vector<std::string> options) {
    options.insert(options.end(), {"-vf", colours, "-colorspace", "bt709", "-color_primaries", "bt709", "-color_trc",
                                   "bt709", "-color_range", "tv"});
    return options;
}

const std::array<Encoding, 3>& encodings() {
    // The GIF's palette is that of each picture: one for all would need all of them in memory.
    static const std::array<Encoding, 3> all{
        {{".mp4", "mp4", with_colours({"-c:v", "libx264", "-crf", "18", "-movflags", "+faststart"}), true},
         {".webm", "webm",
          with_colours({"-c:v", "libvpx-vp9", "-crf", "24", "-b:v", "0", "-row-mt", "1", "-cpu-used", "4"})},
         {".gif",
          "gif",
          {"-filter_complex", "split[a][b];[a]palettegen=stats_mode=single[p];[b][p]paletteuse=new=1:dither=none"},
          false,
          50}}};  // players show faster ones slowly
    return all;
}

std::vector<std::string> arguments(const FilmFormat& format, const Encoding& encoding) {
    std::vector<std::string> all{"ffmpeg", "-nostdin", "-hide_banner", "-loglevel", "error", "-xerror", "-y"};
    // The fourth byte of a pixel is not its opacity.
    all.insert(all.end(),
               {"-f", "rawvideo", "-pix_fmt", "rgb0", "-s", fmt::format("{}x{}", format.size.width, format.size.height),
                "-r", number_text(format.fps), "-i", "pipe:0"});
    all.insert(all.end(), encoding.options.begin(), encoding.options.end());
    all.insert(all.end(), {"-vsync", "passthrough", "-f", std::string(encoding.muxer), ChildProgram::given_file});
    return all;
}

}  // namespace

const Encoding* encoding_of(std::string_view name) {
    const auto& all = encodings();
    const auto found =
        std::find_if(all.begin(), all.end(), [&](const Encoding& each) { return name.ends_with(each.ending); });
    return found == all.end() ? nullptr : &*found;
}

EncodedFilm::EncodedFilm(const FilmFormat& format, const Encoding& encoding)
    : file_(format.name),
      ffmpeg_(std::in_place, arguments(format, encoding), ChildProgram::Input::from_here, file_.descriptor()) {
    if (ffmpeg_->is_missing()) fail();
    file_.at_program_end(UnfinishedFile::AtEnd::kept);
}

void EncodedFilm::add(const Picture& picture, bool) {
    const auto* const bytes = reinterpret_cast<const char*>(picture.rgba.data());
    if (!ffmpeg_->write({bytes, picture.rgba.size()})) fail();
}

void EncodedFilm::finish() {
    if (ffmpeg_->end() != ChildProgram::End::done) fail();
    file_.commit();
}

std::string EncodedFilm::keep() {
    ffmpeg_.reset();  // it writes no more
    const auto kept = file_.keep_partial();
    return kept ? fmt::format("what there is of it is kept in '{}'", shown(*kept)) : "nothing of it was written";
}

void EncodedFilm::fail() {
    check_interruption();  // whoever ends this program may have ended that one too
    if (ffmpeg_->end() == ChildProgram::End::missing)
        throw FileError("cannot run ffmpeg, which writes films: install the package ffmpeg");
    throw FileError(fmt::format("ffmpeg, which writes films, failed: {}", safe_message(ffmpeg_->messages())));
}

}  // namespace steplab
