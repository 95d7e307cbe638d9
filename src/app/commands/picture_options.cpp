#include "app/commands/picture_options.hpp"

#include "app/cli/command_line.hpp"
#include "core/error.hpp"
#include "core/shown.hpp"
#include "ui/widgets/layout.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <utility>

namespace steplab {
namespace {

constexpr int longest_side = 8192;
constexpr render::PictureSize least_with_panel{400, 300};

/// An integer number of pixels; 0 if `text` is none.
int pixels(std::string_view text) {
    int value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    return error == std::errc() && end == text.data() + text.size() ? value : 0;
}

render::PictureSize parse_size(std::string_view text) {
    const std::size_t cross = std::min(text.find('x'), text.size());
    const render::PictureSize size{pixels(text.substr(0, cross)),
                                   cross < text.size() ? pixels(text.substr(cross + 1)) : 0};
    const auto allowed = [](int side) { return side >= 1 && side <= longest_side; };
    if (allowed(size.width) && allowed(size.height)) return size;
    throw UsageError(fmt::format("--size must be WIDTHxHEIGHT in pixels, 1 to {} each, such as 1280x720 (got \"{}\")",
                                 longest_side, shown(text)));
}

/// The scale at which text and lines have the proportions of a picture of the usual size, at least 1.
double usual_scale(render::PictureSize size) {
    const render::PictureSize usual;
    const double smaller =
        std::min(static_cast<double>(size.width) / usual.width, static_cast<double>(size.height) / usual.height);
    return std::max(1.0, std::floor(4 * smaller) / 4);
}

void check_room(std::string_view option, render::PictureSize least, const PictureRequest& request) {
    const double scale = request.style.pixel_scale;
    const auto width = static_cast<int>(std::ceil(scale * least.width));
    const auto height = static_cast<int>(std::ceil(scale * least.height));
    if (request.size.width >= width && request.size.height >= height) return;
    throw UsageError(fmt::format("{} needs a picture of at least {}x{} pixels (--size)", option, width, height));
}

/// Without a caption.
constexpr render::PictureSize least_with_plots{static_cast<int>(ui::narrowest_plot),
                                               static_cast<int>(ui::lowest_with_plots)};

}  // namespace

void PictureOptions::declare(CLI::App& app) {
    const std::string group = picture_group;
    text_option(app, "--size", size_, "WxH",
                fmt::format("Width and height in pixels, up to {} each (default {})", longest_side, size_), group);
    appearance_.declare(
        app, {.group = group,
              .particle = "Mark these particles, the first one first; plots show up to eight",
              .panel = "Draw the window's panels too (default off)",
              .scale = "Scale of text, lines and panels, 0.5 to 8 (default: 1, more in pictures beyond 1280x720)"});
    shown_.declare(
        app,
        {.group = group, .plots = "Plots below the scene with --ui on", .caption = "Write a text below the picture"});
    text_option(app, "--gl", gl_, "auto|osmesa|egl",
                fmt::format("OpenGL context (default {}: the first that works)", gl_), group);
}

PictureRequest PictureOptions::request(const RunDescription& description, std::size_t particles) const {
    PictureRequest request;
    request.size = parse_size(size_);
    const std::string view = appearance_.view(description);
    if (!view.empty()) request.camera = view;
    request.panel = appearance_.panel().value_or(false);
    request.style = appearance_.style(description, particles);
    request.style.pixel_scale = appearance_.scale().value_or(usual_scale(request.size));
    if (auto plots = shown_.plots()) request.plots = std::move(*plots);
    if (shown_.plots() && !request.panel) throw UsageError("--plots is for pictures with --ui on");
    request.caption = shown_.caption();
    if (request.panel) check_room("--ui on", least_with_panel, request);
    if (!request.plots.empty()) check_room("--plots", least_with_plots, request);
    return request;
}

}  // namespace steplab
