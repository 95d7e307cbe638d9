#include "app/commands/snapshot_options.hpp"

#include "app/cli/command_line.hpp"
#include "core/entry.hpp"
#include "core/shown.hpp"
#include "core/text.hpp"
#include "io/output_file.hpp"
#include "sim/catalogue.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <span>

namespace steplab {
namespace {

constexpr int longest_side = 8192;
constexpr render::PictureSize least_with_panel{400, 300};
constexpr ParameterInfo scale_info{
    .name = "--scale", .unit = "", .minimum = 0.5, .maximum = 8, .what = "scale of text and lines"};

/// The index of `word` among the known ones.
std::size_t index_of(std::string_view option, std::string_view word, std::span<const std::string_view> known) {
    const auto found = std::find(known.begin(), known.end(), word);
    if (found == known.end()) throw UsageError(unknown_word(option, word, known));
    return static_cast<std::size_t>(found - known.begin());
}

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

std::size_t parse_particle(std::string_view text, const RunDescription& description) {
    const double count = model(description.model).particles(description.scene);
    const ParameterInfo info{.name = "--particle",
                             .kind = ParameterInfo::Kind::integer,
                             .unit = "",
                             .maximum = count - 1,
                             .what = "particle to mark"};
    return static_cast<std::size_t>(parse_value(info, text));
}

/// The scale at which text and lines have the proportions of a picture of the usual size, at least 1.
double usual_scale(render::PictureSize size) {
    const render::PictureSize usual;
    const double smaller =
        std::min(static_cast<double>(size.width) / usual.width, static_cast<double>(size.height) / usual.height);
    return std::max(1.0, std::floor(4 * smaller) / 4);
}

void check_file(const std::string& name) {
    if (name.empty()) throw UsageError("--out FILE.png is required: the file of the picture");
    if (!written_directly(name) && !name.ends_with(".png")) {
        throw UsageError(fmt::format("--out must end in .png (got \"{}\")", shown(name)));
    }
}

void check_room_for_panel(render::PictureSize size, double scale) {
    const auto width = static_cast<int>(std::ceil(scale * least_with_panel.width));
    const auto height = static_cast<int>(std::ceil(scale * least_with_panel.height));
    if (size.width >= width && size.height >= height) return;
    throw UsageError(fmt::format("--ui on needs a picture of at least {}x{} pixels", width, height));
}

}  // namespace

void SnapshotOptions::declare(CLI::App& app) {
    const std::string group = "Picture";
    const auto add = [&](const char* name, std::string& value, const std::string& placeholder,
                         const std::string& what) { text_option(app, name, value, placeholder, what, group); };
    add("--out", out_, "FILE.png", "File of the picture (required)");
    add("--size", size_, "WxH",
        fmt::format("Width and height in pixels, up to {} each (default {})", longest_side, size_));
    add("--view", view_, "VIEW",
        "Camera: default, front, side, top, or yaw,pitch,distance,x,y,z as copied from the window");
    add("--colour", colour_, "WHAT",
        fmt::format("Quantity shown by colour: {} (default {})", joined(render::colouring_ids), colour_));
    add("--background", background_, "dark|light", fmt::format("Background (default {})", background_));
    add("--particle", particle_, "I", "Mark this particle");
    add("--ui", panel_, "on|off", fmt::format("Draw the window's panels too (default {})", panel_));
    add("--scale", scale_, "X",
        "Scale of text, lines and panels, 0.5 to 8 (default: 1, more in pictures beyond 1280x720)");
    add("--gl", gl_, "auto|osmesa|egl", fmt::format("OpenGL context (default {}: the first that works)", gl_));
}

PictureRequest SnapshotOptions::request(const RunDescription& description) const {
    check_file(out_);
    constexpr std::array<std::string_view, 2> switches{"off", "on"};
    PictureRequest request;
    request.size = parse_size(size_);
    request.camera = view_;
    request.panel = index_of("value of --ui", panel_, switches) == 1;
    render::Style& style = request.style;
    style.pixel_scale = scale_.empty() ? usual_scale(request.size) : parse_value(scale_info, scale_);
    if (request.panel) check_room_for_panel(request.size, style.pixel_scale);
    style.colouring = static_cast<render::Colouring>(index_of("colouring", colour_, render::colouring_ids));
    style.background = static_cast<render::Background>(index_of("background", background_, render::background_ids));
    if (description.scene.contains("m")) style.mass = description.scene["m"];
    if (!particle_.empty()) style.selected = parse_particle(particle_, description);
    return request;
}

}  // namespace steplab
