#include "app/cli/view_choices_file.hpp"

#include "core/error.hpp"
#include "core/number_text.hpp"
#include "core/shown.hpp"
#include "io/output_file.hpp"
#include "io/toml_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string_view>
#include <system_error>
#include <toml++/toml.h>

namespace steplab {
namespace {

namespace fs = std::filesystem;
using ui::PanelSizes;
using ui::PlotChoice;
using ui::ViewChoices;

constexpr std::int64_t version = 1;
constexpr std::array<std::string_view, 3> scale_ids = {"linear", "logarithmic", "symmetric"};

/// Calls visit(key, reference to the value in each of the choices ..., least, most) for every choice but the plots.
template <class Visit, class... Choices>
void for_each_choice(const Visit& visit, Choices&... all) {
    visit("scale", ui::interface_scales.front(), ui::interface_scales.back(), all.scale...);
    visit("theme", 0, 0, all.background...);
    visit("colour", 0, 0, all.colouring...);
    visit("springs", 0, 0, all.springs...);
    visit("grid", 0, 0, all.grid...);
    visit("trail", 0, 0, all.trail...);
    visit("velocities", 0, 0, all.velocities...);
    visit("forces", 0, 0, all.forces...);
    visit("panel", 0, 0, all.panel...);
    visit("panel_width", PanelSizes::least_width, PanelSizes::most_width, all.sizes.panel_width...);
    visit("plots_height", PanelSizes::least_height, PanelSizes::most_height, all.sizes.plots_height...);
    visit("width", 200, 16384, all.width...);
    visit("height", 150, 16384, all.height...);
    visit("picture_of_scene", 0, 0, all.picture.scene_alone...);
    visit("caption", 0, 0, all.picture.caption...);
    visit("film", 0, 0, all.picture.film...);
}

// Each reads a value of its type; false if the node holds no such value.

bool read(const toml::node& node, double least, double most, double& value) {
    const auto number = node.value<double>();
    if (!number || !(*number >= least && *number <= most)) return false;
    value = *number;
    return true;
}

bool read(const toml::node& node, double least, double most, int& value) {
    double number = 0;
    if (!node.is_integer() || !read(node, least, most, number)) return false;
    value = static_cast<int>(number);
    return true;
}

bool read(const toml::node& node, double, double, bool& value) {
    if (!node.is_boolean()) return false;
    value = *node.value<bool>();
    return true;
}

bool read(const toml::node& node, double, double, std::string& value) {
    const auto ending = node.value<std::string>();
    const auto& known = ui::film_endings;
    if (!ending || std::find(known.begin(), known.end(), *ending) == known.end()) return false;
    value = *ending;
    return true;
}

template <class T>
bool read(const toml::node& node, double least, double most, std::optional<T>& value) {
    T present{};
    if (!read(node, least, most, present)) return false;
    value = present;
    return true;
}

template <class Enum, std::size_t N>
bool read_word(const toml::node& node, const std::array<std::string_view, N>& words, Enum& value) {
    const auto word = node.value<std::string_view>();
    const auto found = word ? std::find(words.begin(), words.end(), *word) : words.end();
    if (found == words.end()) return false;
    value = static_cast<Enum>(found - words.begin());
    return true;
}

bool read(const toml::node& node, double, double, Background& value) { return read_word(node, background_ids, value); }
bool read(const toml::node& node, double, double, Colouring& value) { return read_word(node, colouring_ids, value); }

bool read(const toml::node& node, PlotChoice& plot) {
    const toml::table* const table = node.as_table();
    const toml::node* const kind = table ? table->get("kind") : nullptr;
    const toml::node* const scale = table ? table->get("scale") : nullptr;
    const auto id = kind ? kind->value<std::string_view>() : std::nullopt;
    const auto found = std::find_if(ui::plot_kinds.begin(), ui::plot_kinds.end(),
                                    [&](const ui::PlotKindInfo& info) { return info.id == id; });
    if (found == ui::plot_kinds.end()) return false;
    plot = ui::default_choice(found->kind);
    const toml::node* const across = table->get("across");
    return scale && read_word(*scale, scale_ids, plot.scale) &&
           (!across || read_word(*across, scale_ids, plot.across_scale));
}

bool read_plots(const toml::node& node, std::vector<PlotChoice>& plots) {
    const toml::array* const array = node.as_array();
    if (!array || array->empty() || array->size() > ui::PlotsState::most) return false;
    std::vector<PlotChoice> all(array->size());
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (!read(*array->get(i), all[i])) return false;
        for (std::size_t before = 0; before < i; ++before) {
            if (all[before].kind == all[i].kind) return false;
        }
    }
    plots = std::move(all);
    return true;
}

/// Values that cannot be used are left out and named.
void read_table(const toml::table& table, ReadViewChoices& into) {
    std::string unusable;
    const auto attempt = [&](std::string_view key, const auto& reads) {
        const toml::node* const node = table.get(key);
        if (node && !reads(*node))
            unusable += fmt::format("{}{} (line {})", unusable.empty() ? "" : ", ", key, node->source().begin.line);
    };
    for_each_choice(
        [&](std::string_view key, double least, double most, auto& value) {
            attempt(key, [&](const toml::node& node) { return read(node, least, most, value); });
        },
        into.choices);
    attempt("plots", [&](const toml::node& node) { return read_plots(node, into.choices.plots); });
    if (!unusable.empty()) into.problem = fmt::format("the usual values in place of what cannot be used: {}", unusable);
}

// Each writes a value of its type. A number is the shortest that reads back: the library writes 1.1 with 17 digits.

std::string written(double value) { return number_text(value); }
std::string written(int value) { return fmt::format("{}", value); }
std::string written(bool value) { return value ? "true" : "false"; }
std::string written(std::string_view word) { return fmt::format("'{}'", word); }
std::string written(const std::string& word) { return written(std::string_view(word)); }
std::string written(Background value) { return written(id(value)); }
std::string written(Colouring value) { return written(id(value)); }

template <class T>
void add_line(std::string& text, std::string_view key, const T& value) {
    text += fmt::format("{} = {}\n", key, written(value));
}
template <class T>
void add_line(std::string& text, std::string_view key, const std::optional<T>& value) {
    if (value) add_line(text, key, *value);
}

std::string written(const PlotChoice& plot) {
    return fmt::format("{{ kind = {}, scale = {}, across = {} }}",
                       written(ui::plot_kinds[static_cast<std::size_t>(plot.kind)].id),
                       written(scale_ids[static_cast<std::size_t>(plot.scale)]),
                       written(scale_ids[static_cast<std::size_t>(plot.across_scale)]));
}

std::string text_of(const ViewChoices& choices) {
    std::string text = fmt::format(
        "# What the window of steplab remembers. Without this file it opens as usual.\n"
        "version = {}\n",
        version);
    for_each_choice([&](std::string_view key, double, double, const auto& value) { add_line(text, key, value); },
                    choices);
    text += "plots = [\n";
    for (const PlotChoice& plot : choices.plots) text += fmt::format("    {},\n", written(plot));
    return text + "]\n";
}

/// Puts what has changed into the choices that are remembered; false if nothing has.
bool put_changes(const ViewChoices& opened, const ViewChoices& now, ViewChoices& remembered) {
    bool changed = false;
    for_each_choice(
        [&](std::string_view, double, double, const auto& before, const auto& after, auto& kept) {
            if (before == after) return;
            kept = after;
            changed = true;
        },
        opened, now, remembered);
    if (opened.plots != now.plots) {
        remembered.plots = now.plots;
        changed = true;
    }
    return changed;
}

std::string setting(const char* name) {
    const char* const value = std::getenv(name);
    return value ? value : "";
}

}  // namespace

std::string view_choices_path(const std::string& config) {
    if (config == "none") return {};
    if (!config.empty()) return config;
    const fs::path named = setting("XDG_CONFIG_HOME"), home = setting("HOME");
    if (named.is_absolute()) return named / "steplab" / "view.toml";
    return home.is_absolute() ? (home / ".config" / "steplab" / "view.toml").string() : std::string();
}

namespace {

std::string content_of(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    std::string text((std::istreambuf_iterator<char>(file)), {});
    if (!file) throw FileError("it cannot be read");
    return text;
}

}  // namespace

ReadViewChoices read_view_choices(const std::string& path) {
    ReadViewChoices result;
    std::error_code none;
    if (path.empty() || !fs::exists(path, none)) return result;
    try {
        if (!fs::is_regular_file(path, none)) throw FileError("it is no file");
        const toml::table table = toml_table(content_of(path), path);
        const auto written = table["version"].value<std::int64_t>();
        result.newer = written && *written > version;
        if (result.newer) {
            result.problem = "written by a newer version";
        } else {
            read_table(table, result);
        }
    } catch (const toml::parse_error& error) {
        result.problem = fmt::format("line {}: {}", error.source().begin.line, error.description());
    } catch (const FileError& error) {
        result.problem = error.what();
    }
    if (result.problem) result.problem = fmt::format("{}: {}", shown(path), *result.problem);
    return result;
}

void remember_view_choices(const std::string& path, const ViewChoices& opened, const ViewChoices& now) {
    if (path.empty()) return;
    ReadViewChoices remembered = read_view_choices(path);
    if (remembered.newer || !put_changes(opened, now, remembered.choices)) return;
    std::error_code ignored;  // OutputFile names what is wrong
    const fs::path folder = fs::path(path).parent_path();
    if (!folder.empty()) fs::create_directories(folder, ignored);
    if (remembered.problem)  // a person wrote that
        fs::copy_file(path, path + ".unreadable", fs::copy_options::overwrite_existing, ignored);
    OutputFile file(path);
    file.write(text_of(remembered.choices));
    file.commit();
}

}  // namespace steplab
