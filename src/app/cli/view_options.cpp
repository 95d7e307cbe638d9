#include "app/cli/view_options.hpp"

#include "app/cli/command_line.hpp"
#include "core/entry.hpp"
#include "core/error.hpp"
#include "core/shown.hpp"

#include <fmt/format.h>

#include <charconv>

namespace steplab {
namespace {

constexpr ParameterInfo scale_info{
    .name = "--scale", .unit = "", .minimum = 0.5, .maximum = 8, .what = "scale of the interface"};
constexpr int smallest = 100;
constexpr int largest = 16384;

/// Reads an integer from the front of `text` and removes it; 0 if there is none.
int take_number(std::string_view& text) {
    int number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc{}) return 0;
    text.remove_prefix(static_cast<std::size_t>(end - text.data()));
    return number;
}

void read_size(std::string_view text, WindowRequest& request) {
    const std::string all(text);
    request.width = take_number(text);
    const bool has_cross = text.starts_with('x');
    if (has_cross) text.remove_prefix(1);
    request.height = take_number(text);
    const auto allowed = [](int length) { return length >= smallest && length <= largest; };
    if (has_cross && text.empty() && allowed(request.width) && allowed(request.height)) return;
    throw UsageError(fmt::format("--size must be WIDTHxHEIGHT in pixels, {} to {} each, such as 1280x800 (got \"{}\")",
                                 smallest, largest, shown(all)));
}

}  // namespace

void ViewOptions::declare(CLI::App& app) {
    text_option(app, "--size", size_, "WxH", "Size of the window in pixels (default 1280x800)");
    text_option(app, "--scale", scale_, "X", "Scale of the interface, 0.5 to 8 (default: that of the display)");
    text_option(app, "--view", view_, "VIEW", "Camera: default, front, side, top, or a text copied by \"Copy view\"");
    text_option(app, "--trace", trace_, "FILE|-", "Write a line for each event in the window");
    flag_option(app, "--full-screen", full_screen_, "Open in full screen");
    flag_option(app, "--play", playing_, "Start playing at once");
}

WindowRequest ViewOptions::request() const {
    WindowRequest request;
    request.view = view_;
    request.trace = trace_;
    request.full_screen = full_screen_;
    request.playing = playing_;
    read_size(size_, request);
    if (!scale_.empty()) request.scale = static_cast<float>(parse_value(scale_info, scale_));
    return request;
}

}  // namespace steplab
