#pragma once

#include "render/shown_runs.hpp"
#include "session/run_name.hpp"
#include "session/run_view.hpp"

#include <vector>

namespace steplab {

/// The runs as they are drawn, the leading one first; of frames of the views, which have to stay.
inline std::vector<render::ShownRun> shown_runs(const RunView& leading, const std::vector<RunView>& followers) {
    std::vector<render::ShownRun> runs{
        {&leading.frame, run_name(leading.description, leading.description), leading.swatch}};
    for (const RunView& run : followers) {
        const char* const end = run.divergence ? ", diverged" : "";
        runs.push_back({&run.frame, run_name(run.description, leading.description) + end, run.swatch});
    }
    return runs;
}

}  // namespace steplab
