#pragma once

#include "app/cli/compared_runs.hpp"
#include "render/style.hpp"

#include <string>
#include <vector>

namespace steplab {

/// The options of drawing several runs of one scene, the same for pictures and the window: --run, --layout, --magnify.
class ShownRunsOptions {
public:
    void declare(CLI::App& app);
    /// Whether one of them is given.
    bool are_given() const;
    /// The runs, the leading one first: that of the scene alone where no --run is given. Throws UsageError.
    std::vector<RunDescription> runs(const RunDescription& scene) const;
    /// Sets what --layout and --magnify say. Throws UsageError, also where one of them is given without --run.
    void put_into(render::Style& style) const;

private:
    const CLI::App* app_ = nullptr;
    ComparedRuns runs_;
    std::string layout_ = std::string(id(render::RunLayout::ghosts));
    std::string magnify_ = "1";
};

}  // namespace steplab
