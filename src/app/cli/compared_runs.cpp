#include "app/cli/compared_runs.hpp"

#include "app/cli/command_line.hpp"
#include "core/error.hpp"

#include <fmt/format.h>

#include <utility>

namespace steplab {

void ComparedRuns::declare(CLI::App& app) {
    repeated_option(app, "--run", texts_, "name=value,...",
                    "A run: method, dt, precision and parameters that differ from the options; two to four", "Compare");
}

std::vector<RunDescription> ComparedRuns::runs(const RunDescription& scene) const {
    std::vector<RunDescription> runs;
    const auto add = [&](const std::string& text) {
        RunDescription run = variant_of(scene, text);
        check(run);
        runs.push_back(std::move(run));
    };
    for (const std::string& text : texts_) {
        try {
            add(text);
        } catch (const UsageError& error) {
            throw UsageError(fmt::format("--run {}: {}", text, error.what()));
        }
    }
    if (runs.empty()) runs.push_back(scene);
    if (scene.origin) {
        for (const std::string& text : scene.origin->defaults.compare) add(text);
    }
    if (runs.size() < 2 || runs.size() > most)
        throw UsageError(fmt::format("{} to compare: give two to four --run method=ID,dt=X",
                                     runs.size() == 1 ? "one run" : fmt::format("{} runs", runs.size())));
    return runs;
}

}  // namespace steplab
