#include "app/commands/film_options.hpp"

#include "app/cli/command_line.hpp"
#include "core/entry.hpp"

#include <fmt/format.h>

namespace steplab {
namespace {

constexpr ParameterInfo fps_info{
    .name = "--fps", .unit = "", .minimum = 1, .maximum = 1000, .what = "frames per second of the film"};
constexpr ParameterInfo speed_info{.name = "--speed",
                                   .unit = "",
                                   .minimum = 1e-30,
                                   .maximum = 1e30,
                                   .what = "simulated seconds per second of the film"};

}  // namespace

void FilmOptions::declare(CLI::App& app) {
    const std::string group = "Film";
    text_option(app, "--out", out_, "FILE",
                "File of the film (required): .mp4, .webm, .gif, or a series of pictures such as frames/%05d.png",
                group);
    text_option(app, "--fps", fps_, "N", fmt::format("Frames per second (default {})", fps_), group);
    text_option(app, "--speed", speed_, "S",
                fmt::format("Simulated seconds per second of the film (default {})", speed_), group);
    picture_.declare(app);
}

PictureRequest FilmOptions::request(const RunDescription& description, std::size_t particles) const {
    return picture_.request(description, particles);
}

FilmFormat FilmOptions::format(render::PictureSize size) const {
    FilmFormat format{out_, size, fps()};
    check_film(format);
    return format;
}

double FilmOptions::spacing() const { return parse_value(speed_info, speed_) / fps(); }

double FilmOptions::fps() const { return parse_value(fps_info, fps_); }

}  // namespace steplab
