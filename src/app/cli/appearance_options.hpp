#pragma once

#include "render/style.hpp"
#include "sim/run/run_description.hpp"
#include "ui/view_choices.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace CLI {
class App;
}

namespace steplab {

/// The options of how a run is shown, the same for pictures and the window: --view, --colour, --background, --particle,
/// --springs, --grid, --velocities, --forces, --displacements, --ui and --scale.
class AppearanceOptions {
public:
    /// The texts of the help that differ between pictures and the window.
    struct Help {
        std::string group;
        std::string particle;
        std::string panel;
        std::string scale;
    };
    void declare(CLI::App& app, const Help& help);

    /// How the scene is drawn, without pixel_scale: as is given, else as the scene's file says. Throws UsageError for
    /// values of another form or out of range. `particles`: how many there are; 0: as the description says.
    render::Style style(const RunDescription& description, std::size_t particles = 0) const;
    /// Puts what a person chose before into a style, where neither the command line nor the scene's file says it.
    void put_remembered(const ui::ViewChoices& choices, const RunDescription& description, render::Style& style) const;
    /// The camera as text, to be read by render::camera_of(): that given, else that of the scene's file; empty if there
    /// is none.
    const std::string& view(const RunDescription& description) const;
    /// With the panel or without; none if that was not said. Throws UsageError.
    std::optional<bool> panel() const;
    /// Pixels per unit of the layout; none if that was not given. Throws UsageError.
    std::optional<double> scale() const;

private:
    const std::string& said(const RunDescription& description, const char* option, const std::string& value,
                            std::string SceneDefaults::*of_file) const;

    bool says(const RunDescription& description, const char* option, std::string SceneDefaults::*of_file) const;

    const CLI::App* app_ = nullptr;
    std::string view_;
    std::string colour_ = "role";
    std::string background_ = "dark";
    std::string particle_;
    std::string springs_ = "on";
    std::string grid_ = "on";
    std::string velocities_ = "off";
    std::string forces_ = "off";
    std::string displacements_ = "1";
    std::string panel_;
    std::string scale_;
};

/// The value of an option that is on or off. Throws UsageError for another word.
bool is_on(std::string_view option, std::string_view word);

/// Throws UsageError if the style names a column that is none of those of the file that is played; none: no file is.
void check_column(const render::Style& style, const std::vector<std::string>& columns);

}  // namespace steplab
