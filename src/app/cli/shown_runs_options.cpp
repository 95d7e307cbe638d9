#include "app/cli/shown_runs_options.hpp"

#include "app/cli/command_line.hpp"
#include "core/entry.hpp"
#include "core/error.hpp"
#include "core/text.hpp"
#include "models/model.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace steplab {
namespace {

constexpr ParameterInfo magnify_info{.name = "--magnify",
                                     .unit = "",
                                     .minimum_included = false,
                                     .maximum = render::most_magnified,
                                     .what = "factor of the differences from the leading run"};

render::RunLayout layout_of(const std::string& word) {
    const auto& ids = render::run_layout_ids;
    const auto found = std::find(ids.begin(), ids.end(), word);
    if (found == ids.end()) throw UsageError(unknown_word("layout (--layout)", word, ids));
    return static_cast<render::RunLayout>(found - ids.begin());
}

}  // namespace

void ShownRunsOptions::declare(CLI::App& app) {
    app_ = &app;
    runs_.declare(app);
    text_option(app, "--layout", layout_, "ghosts|split",
                fmt::format("Other runs as ghosts around the first, or each in a tile (default {})", layout_),
                "Compare");
    text_option(app, "--magnify", magnify_, "F", "Draw ghosts F times as far from the first run (default 1)",
                "Compare");
}

bool ShownRunsOptions::are_given() const {
    const std::array names{"--run", "--layout", "--magnify"};
    return std::any_of(names.begin(), names.end(), [this](const char* name) { return is_given(*app_, name); });
}

std::vector<RunDescription> ShownRunsOptions::runs(const RunDescription& scene) const {
    if (!runs_.are_given()) return {scene};
    std::vector<RunDescription> runs = runs_.runs(scene);
    const auto particles = [](const RunDescription& run) { return model_of(run).particles(run.scene); };
    for (const RunDescription& run : runs) {
        if (run.dt < 0) throw UsageError("runs beside each other go forward in time: dt must be > 0");
        if (particles(run) != particles(runs.front()))
            throw UsageError("runs beside each other must have the same particles");
    }
    return runs;
}

void ShownRunsOptions::put_into(render::Style& style) const {
    for (const char* option : {"--layout", "--magnify"}) {
        if (is_given(*app_, option) && !runs_.are_given())
            throw UsageError(fmt::format("{} is for several runs: give two to four --run method=ID,dt=X", option));
    }
    style.layout = layout_of(layout_);
    style.magnify = parse_value(magnify_info, magnify_);
    if (style.layout == render::RunLayout::split && is_given(*app_, "--magnify"))
        throw UsageError("--magnify is for ghosts, not for --layout split");
}

}  // namespace steplab
