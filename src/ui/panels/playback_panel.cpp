#include "ui/actions.hpp"
#include "ui/panels/panels.hpp"
#include "ui/widgets/widgets.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <string>

namespace steplab::ui {
namespace {

/// How the run was computed that wrote the file.
void draw_run(const Context& context) {
    const RunDescription& run = context.view.description;
    reading_row(context, "method", run.method);
    reading_row(context, "precision", id(run.precision));
    reading_row(context, "dt", fmt::format("{} s", format_value(dt_parameter, run.dt)));
    for (const ParameterValues* values : {&run.method_parameters, &run.scene}) {
        for (const ParameterInfo& info : values->infos()) {
            const std::string unit = info.unit.empty() ? "" : fmt::format(" {}", info.unit);
            reading_row(context, info.name, format_value(info, (*values)[info.name]) + unit, info.what);
        }
    }
}

}  // namespace

void draw_playback_panel(const Context& context) {
    const PlaybackView& playback = *context.session.playback;
    heading(context, "PLAYBACK");
    reading_row(context, "file", std::filesystem::path(playback.file).filename().string(), playback.file);
    reading_row(context, "frame", fmt::format("{} of {}", playback.frame + 1, playback.frames));
    if (!playback.units.empty())
        reading_row(
            context, "units", playback.units,
            "The file has its numbers in these units of LAMMPS. They are shown as they are: where kg, m, s and J "
            "stand here, they mean the units of the file.");
    if (playback.looked_through < 1)
        reading_row(context, "looked through", fmt::format("{:.0f} %", 100 * playback.looked_through),
                    "Frames are looked for in the whole file, and shown as they are found.");
    if (!playback.fault.empty()) explanation(context, playback.fault, colour::caution);
    if (playback.measured) return draw_run(context);
    explanation(context, "The file does not have a whole scene: energies and forces are not known.");
}

}  // namespace steplab::ui
