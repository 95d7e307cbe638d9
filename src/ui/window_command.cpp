#include "ui/window_command.hpp"

#include "core/number_text.hpp"
#include "core/shell_word.hpp"
#include "render/colouring.hpp"
#include "render/framing.hpp"
#include "sim/run/run_variant.hpp"
#include "ui/actions.hpp"

#include <fmt/format.h>

namespace steplab::ui {
namespace {

/// Appends options whose values differ from their defaults.
struct CommandLine {
    std::string text;

    void add(std::string_view option, std::string_view value) {
        text.append(" ").append(option);
        if (!value.empty()) text.append(" ").append(value);
    }
    void add_unless(bool usual, std::string_view option, std::string_view value) {
        if (!usual) add(option, value);
    }
};

/// "energy-error,displacement".
std::string plot_words(const PlotsState& plots) {
    std::string words;
    for (const PlotChoice& plot : plots.shown)
        words.append(words.empty() ? "" : ",").append(plot_word(info_of(plot.kind)));
    return words;
}

/// As a list of particles, "9,0-3", the first one first.
std::string list_of(std::size_t first, const ParticleList& others) {
    std::string list = std::to_string(first);
    for (const std::size_t* from = others.begin(); from != others.end();) {
        const std::size_t* to = from;
        while (to + 1 != others.end() && *(to + 1) == *to + 1) ++to;
        list += from == to ? fmt::format(",{}", *from) : fmt::format(",{}-{}", *from, *to);
        from = to + 1;
    }
    return list;
}

void add_moment(CommandLine& line, const Context& context) {
    if (!command_repeats_run(context)) return;
    const std::uint64_t step = context.view.frame.step;
    line.add_unless(step == 0, "--steps", std::to_string(step));
    line.add_unless(!context.state.wanted.playing(), "--play", "");
}

void add_window(CommandLine& line, const Context& context) {
    const Display& display = context.display;
    line.add_unless(display.width == 1280 && display.height == 800, "--size",
                    fmt::format("{}x{}", display.width, display.height));
    line.add_unless(display.scale == 1 && context.state.scale == 1, "--scale", number_text(display.scale));
    if (context.state.panel) line.add("--ui", *context.state.panel ? "on" : "off");
    line.add("--config", "none");  // whatever is remembered by then: what is left out above is as usual
}

void add_picture(CommandLine& line, const Context& context) {
    const render::Style& style = context.stage.style;
    const render::Camera& camera = context.stage.camera;
    const Frame& frame = context.view.frame;
    const auto& origin = context.description().origin;
    const auto said = [&](std::string SceneDefaults::*of_file, std::string_view usual) {
        return origin && !((*origin).defaults.*of_file).empty() ? std::string_view((*origin).defaults.*of_file) : usual;
    };
    // without --view a window keeps the camera of the start
    const bool usual = camera == home_camera(context);
    const std::string view = usual ? std::string(said(&SceneDefaults::camera, "default")) : render::view_text(camera);
    line.add_unless(usual && frame.step == 0, "--view", view);
    const std::string colour = render::colour_word(frame, style);
    const std::string_view background = id(style.background);
    line.add_unless(colour == said(&SceneDefaults::colour, id(render::Style{}.colouring)), "--colour",
                    shell_word(colour));
    line.add_unless(background == said(&SceneDefaults::background, id(render::Style{}.background)), "--background",
                    background);
    line.add_unless(style.springs, "--springs", "off");
    line.add_unless(style.grid, "--grid", "off");
    line.add_unless(!style.velocities, "--velocities", "on");
    line.add_unless(!style.forces, "--forces", "on");
    line.add_unless(!context.state.trail, "--trail", "on");
    line.add_unless(style.displacements == 1, "--displacements", number_text(style.displacements));
    const auto& tracked = context.view.tracked;
    const ParticleList& others = context.state.selection.others();
    if (tracked && (tracked->particle != first_followed(*frame.shape) || !others.empty()))
        line.add("--particle", list_of(tracked->particle, others));
}

/// What stands below the scene, and below saved pictures.
void add_content(CommandLine& line, const Context& context) {
    const std::string plots = plot_words(context.state.plots), usual = plot_words(PlotsState{});
    line.add_unless(plots.empty() || plots == usual, "--plots", plots);
    const PictureChoice& picture = context.state.picture;
    if (picture.caption)
        line.add("--caption", picture.caption_text.empty() ? "auto" : shell_word(picture.caption_text));
}

void add_speed(CommandLine& line, const Rate& rate) {
    if (rate == Rate{}) return;
    line.add("--speed", rate.as_fast_as_possible ? "unlimited" : number_text(rate.seconds_per_second));
}

void add_ensemble(CommandLine& line, const LiveEnsembleOptions& ensemble, const RunDescription& description) {
    if (ensemble.runs == 0) return;
    line.add("--ensemble", std::to_string(ensemble.runs));
    for (const ParameterRange& range : ranges_of(ensemble, description)) {
        line.add("--spread", fmt::format("{}={}:{}", range.name, number_text(range.from), number_text(range.to)));
    }
}

void add_runs(CommandLine& line, const Context& context) {
    if (context.session.followers.empty()) return;
    const RunDescription& leading = context.description();
    line.add("--run", variant_text(leading, leading));
    for (const RunView& run : context.session.followers) line.add("--run", variant_text(run.description, leading));
    const render::Style& style = context.stage.style;
    const bool split = style.layout == render::RunLayout::split;
    line.add_unless(!split, "--layout", id(style.layout));
    line.add_unless(split || style.magnify == 1, "--magnify", number_text(style.magnify));
}

}  // namespace

bool command_repeats_run(const Context& context) {
    return context.view.segment_start == 0 && context.state.hands.pulled_in != context.view.run &&
           context.view.description.alterations.empty();
}

std::string window_command(const Context& context) {
    const auto& playback = context.session.playback;
    CommandLine line{"steplab view " +
                     (playback ? "--trajectory " + shell_word(playback->file) : command_line(context.description()))};
    add_moment(line, context);
    add_picture(line, context);
    add_content(line, context);
    add_speed(line, context.state.wanted.rate());
    add_ensemble(line, context.state.wanted.ensemble(), context.description());
    add_runs(line, context);
    add_window(line, context);
    return line.text;
}

}  // namespace steplab::ui
