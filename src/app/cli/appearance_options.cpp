#include "app/cli/appearance_options.hpp"

#include "app/cli/command_line.hpp"
#include "app/cli/particle_list.hpp"
#include "core/entry.hpp"
#include "core/error.hpp"
#include "core/shown.hpp"
#include "core/text.hpp"
#include "render/colouring.hpp"
#include "sim/catalogue.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>
#include <vector>

namespace steplab {
namespace {

constexpr ParameterInfo scale_info{
    .name = "--scale", .unit = "", .minimum = 0.5, .maximum = 8, .what = "scale of text and lines"};

constexpr ParameterInfo displacements_info{.name = "--displacements",
                                           .unit = "",
                                           .minimum_included = false,
                                           .maximum = render::most_magnified,
                                           .what = "factor by which displacements are drawn"};

std::size_t particles_of(const RunDescription& run) {
    return static_cast<std::size_t>(model_of(run).particles(run.scene));
}

/// The first one of the list first.
void select(std::string_view list, std::size_t count, render::Style& style) {
    std::vector<std::size_t> all = parse_particles("--particle", list, count);
    style.selected = parse_particles("--particle", list.substr(0, list.find_first_of(",-")), count).front();
    std::erase(all, *style.selected);
    style.selected_too = ParticleList(std::move(all));
}

}  // namespace

bool is_on(std::string_view option, std::string_view word) {
    constexpr std::array<std::string_view, 2> switches{"off", "on"};
    if (std::find(switches.begin(), switches.end(), word) == switches.end())
        throw UsageError(unknown_word(fmt::format("value of {}", option), word, switches));
    return word == switches[1];
}

void AppearanceOptions::declare(CLI::App& app, const Help& help) {
    app_ = &app;
    const auto add = [&](const char* name, std::string& value, const char* placeholder, const std::string& what) {
        text_option(app, name, value, placeholder, what, help.group);
    };
    add("--view", view_, "VIEW",
        "Camera: default, front, side, top, or yaw,pitch,distance,x,y,z as copied from the window");
    add("--colour", colour_, "WHAT",
        fmt::format("Quantity shown by colour: {}, or column:NAME of a file that is played (default {})",
                    joined(render::colouring_ids), colour_));
    add("--background", background_, "dark|light", fmt::format("Theme of scene and panels (default {})", background_));
    add("--particle", particle_, "9,0-3", help.particle);
    add("--springs", springs_, "on|off", fmt::format("Draw the springs (default {})", springs_));
    add("--grid", grid_, "on|off", fmt::format("Draw the ground grid and the axes (default {})", grid_));
    add("--velocities", velocities_, "on|off",
        fmt::format("Draw the velocity of each particle as an arrow (default {})", velocities_));
    add("--forces", forces_, "on|off",
        fmt::format("Draw the force on each particle as an arrow (default {})", forces_));
    add("--displacements", displacements_, "F", "Draw displacements F times as large (default 1)");
    add("--ui", panel_, "on|off", help.panel);
    add("--scale", scale_, "X", help.scale);
}

/// The value of an option, which goes before what the scene's file says.
const std::string& AppearanceOptions::said(const RunDescription& description, const char* option,
                                           const std::string& value, std::string SceneDefaults::*of_file) const {
    if (!description.origin || is_given(*app_, option)) return value;
    const std::string& file = description.origin->defaults.*of_file;
    return file.empty() ? value : file;
}

render::Style AppearanceOptions::style(const RunDescription& description, std::size_t particles) const {
    render::Style style;
    const std::string& colour = said(description, "--colour", colour_, &SceneDefaults::colour);
    if (colour.starts_with(render::column_prefix)) {
        style.column = colour.substr(render::column_prefix.size());
    } else {
        style.colouring = colouring_of(colour);
    }
    style.background = background_of(said(description, "--background", background_, &SceneDefaults::background));
    style.springs = is_on("--springs", springs_);
    style.grid = is_on("--grid", grid_);
    style.velocities = is_on("--velocities", velocities_);
    style.forces = is_on("--forces", forces_);
    style.displacements = parse_value(displacements_info, displacements_);
    style.mass = facts_of(description).mass;
    if (!particle_.empty()) select(particle_, particles > 0 ? particles : particles_of(description), style);
    return style;
}

/// True if the command line or the scene's file says it.
bool AppearanceOptions::says(const RunDescription& description, const char* option,
                             std::string SceneDefaults::*of_file) const {
    return is_given(*app_, option) || (description.origin && !(description.origin->defaults.*of_file).empty());
}

void AppearanceOptions::put_remembered(const ui::ViewChoices& choices, const RunDescription& description,
                                       render::Style& style) const {
    if (!says(description, "--colour", &SceneDefaults::colour)) style.colouring = choices.colouring;
    if (!says(description, "--background", &SceneDefaults::background)) style.background = choices.background;
    if (!is_given(*app_, "--springs")) style.springs = choices.springs;
    if (!is_given(*app_, "--grid")) style.grid = choices.grid;
    if (!is_given(*app_, "--velocities")) style.velocities = choices.velocities;
    if (!is_given(*app_, "--forces")) style.forces = choices.forces;
}

void check_column(const render::Style& style, const std::vector<std::string>& columns) {
    if (style.column.empty()) return;
    const std::vector<std::string_view> known(columns.begin(), columns.end());
    if (known.empty())
        throw UsageError(
            fmt::format("--colour column:{}: there is no column besides positions and velocities; XYZ files and LAMMPS "
                        "dumps that are played (--trajectory FILE) may have some",
                        shown(style.column)));
    if (std::find(known.begin(), known.end(), style.column) == known.end())
        throw UsageError(unknown_word("column", style.column, known));
}

const std::string& AppearanceOptions::view(const RunDescription& description) const {
    return said(description, "--view", view_, &SceneDefaults::camera);
}

std::optional<bool> AppearanceOptions::panel() const {
    return panel_.empty() ? std::nullopt : std::optional(is_on("--ui", panel_));
}

std::optional<double> AppearanceOptions::scale() const {
    return scale_.empty() ? std::nullopt : std::optional(parse_value(scale_info, scale_));
}

}  // namespace steplab
