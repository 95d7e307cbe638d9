#include "app/cli/view_options.hpp"

#include "app/cli/command_line.hpp"
#include "core/entry.hpp"
#include "core/error.hpp"

#include <fmt/format.h>

#include <charconv>

namespace steplab {
namespace {

constexpr ParameterInfo scale_info{
    .name = "--scale", .unit = "", .minimum = 0.5, .maximum = 8, .what = "size of the interface"};
constexpr int smallest = 100;
constexpr int largest = 16384;

/// Reads a whole number from `text` and removes it; 0 where there is none.
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
    const bool parted = text.starts_with('x');
    if (parted) text.remove_prefix(1);
    request.height = take_number(text);
    const auto possible = [](int length) { return length >= smallest && length <= largest; };
    if (parted && text.empty() && possible(request.width) && possible(request.height)) return;
    throw UsageError(fmt::format("--size '{}' is not WIDTHxHEIGHT in pixels, {} to {} each, such as 1280x800", all,
                                 smallest, largest));
}

}  // namespace

void ViewOptions::declare(CLI::App& app) {
    text_option(app, "--size", size_, "WxH", "size of the window in pixels (1280x800)");
    text_option(app, "--scale", scale_, "X", "size of the interface: 2 is twice as large (as the display says)");
    text_option(app, "--view", view_, "VIEW", "camera: what \"Copy view\" gives, or default, front, side, top");
    text_option(app, "--trace", trace_, "FILE|-", "write a line for everything that happens in the window");
    flag_option(app, "--full-screen", full_screen_, "open on the whole screen");
    flag_option(app, "--play", playing_, "start playing");
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
