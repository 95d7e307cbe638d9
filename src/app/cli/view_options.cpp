#include "app/cli/view_options.hpp"

#include "app/cli/command_line.hpp"
#include "core/entry.hpp"
#include "core/error.hpp"
#include "core/shown.hpp"

#include <fmt/format.h>

#include <charconv>
#include <utility>

namespace steplab {
namespace {

constexpr ParameterInfo speed_info{
    .name = "--speed", .unit = "", .minimum_included = false, .what = "simulated seconds per second of real time"};
constexpr std::string_view unlimited = "unlimited";
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

Rate parse_speed(std::string_view text) {
    if (text == unlimited) return {.as_fast_as_possible = true};
    try {
        return {.as_fast_as_possible = false, .seconds_per_second = parse_value(speed_info, text)};
    } catch (const UsageError& error) {
        throw UsageError(fmt::format("{}, or {}", error.what(), unlimited));
    }
}

}  // namespace

void ViewOptions::declare(CLI::App& app) {
    app_ = &app;
    time_.declare(app);
    const std::string group = "Window";
    text_option(app, "--size", size_, "WxH", "Size of the window in pixels (default 1280x800)", group);
    appearance_.declare(app, {.group = group,
                              .particle = "Select these particles, the first one first",
                              .panel = "Show the panel and the plots (default: where the window has room)",
                              .scale = "Scale of the interface, 0.5 to 8 (default: that of the display)"});
    content_.declare(app, {.group = group,
                           .plots = "Plots below the scene",
                           .caption = "Saved pictures and films have a text below them"});
    text_option(app, "--trail", trail_, "on|off", "Draw where the selected particle has been (default off)", group);
    text_option(app, "--speed", speed_, "X|unlimited", "Simulated seconds per second of real time (default 1)", group);
    flag_option(app, "--play", playing_, "Start playing at once, after --steps or --until", group);
    flag_option(app, "--full-screen", full_screen_, "Open in full screen", group);
    text_option(app, "--config", config_, "FILE|none",
                "Where the window remembers scale, theme, panels, plots and its size; none: neither read nor written "
                "(default: steplab/view.toml in XDG_CONFIG_HOME or ~/.config)",
                group);
    session_.declare(app);
    text_option(app, "--trace", trace_, "FILE|-", "Write a line for each event in the window", group);
    ensemble_.declare(app);
    runs_.declare(app);
}

/// What is played has its own runs.
void ViewOptions::check_beside(const GivenSession& session) const {
    const std::string played = session.played();
    if (played.empty()) return;
    const auto refuse = [&](std::string_view option) {
        throw UsageError(
            fmt::format("{} goes beside a run, but {} is played alone: leave it out, or give a scene "
                        "(--model, --scene) in place of what is played",
                        option, played));
    };
    if (runs_.are_given()) refuse("--run");
    if (!session.lesson && ensemble_.is_given()) refuse("--ensemble");
}

WindowRequest ViewOptions::request(const std::vector<RunDescription>& runs, GivenSession session) const {
    check_beside(session);
    const RunDescription& description = runs.front();
    WindowRequest request;
    request.followers.assign(runs.begin() + 1, runs.end());
    read_size(size_, request);
    if (const auto scale = appearance_.scale()) request.scale = static_cast<float>(*scale);
    request.view = appearance_.view(description);
    request.style = appearance_.style(description, session.particles);
    runs_.put_into(request.style);
    request.panel = appearance_.panel();
    request.steps = time_.steps(description);
    if (!speed_.empty()) request.rate = parse_speed(speed_);
    if (ensemble_.is_given())
        request.ensemble = nearest_live_ensemble(description, ensemble_.count(), ensemble_.ranges(description));
    request.config = config_;
    request.trace = trace_;
    if (!trail_.empty()) is_on("--trail", trail_);  // a wrong word is reported now
    request.full_screen = full_screen_;
    request.playing = playing_ || session.film;
    if (session.film && request.steps > 0)
        throw UsageError("--steps and --until are of a new run: a session that is played begins at its start");
    check_column(request.style, session.columns);
    request.session = std::move(session);
    return request;
}

void ViewOptions::put_remembered(const ui::ViewChoices& choices, const RunDescription& description,
                                 WindowRequest& request) const {
    request.choices = request.remembered = choices;
    appearance_.put_remembered(choices, description, request.style);
    if (!trail_.empty()) request.choices.trail = is_on("--trail", trail_);
    if (request.panel) request.choices.panel = request.panel;
    request.panel = request.choices.panel;
    if (const auto plots = content_.plots()) {
        request.choices.plots.clear();
        for (const ui::PlotKind kind : *plots) request.choices.plots.push_back(ui::default_choice(kind));
    }
    if (const auto caption = content_.caption()) {
        request.choices.picture.caption = true;
        request.choices.picture.caption_text = caption->text;
    }
    if (request.scale) request.choices.scale = 1;  // the scale that is given is that of the interface
    if (is_given(*app_, "--size")) return;
    request.width = choices.width;
    request.height = choices.height;
}

}  // namespace steplab
