#include "app/commands/limits.hpp"

#include "app/cli/catalogue_text.hpp"
#include "app/cli/command_line.hpp"
#include "app/cli/progress.hpp"
#include "app/cli/scene_options.hpp"
#include "app/cli/standard_streams.hpp"
#include "app/commands/limits_text.hpp"
#include "core/error.hpp"
#include "core/interruption.hpp"
#include "core/shown.hpp"
#include "core/watching.hpp"
#include "lab/limits/all_limits.hpp"

#include <fmt/format.h>

#include <unistd.h>

namespace steplab {

namespace {

constexpr const char* limits_examples =
    "Examples:\n"
    "  steplab limits --model chain --method all\n"
    "  steplab limits --model rope --set c=3 --method rk4 --json\n\n";

constexpr const char* explained =
    "\nLargest dt [s] at which small vibrations do not grow: from linear theory, and measured on runs.\n";

class LimitsCommand final : public Command {
public:
    std::string_view name() const override { return "limits"; }
    std::string_view what() const override { return "Find the largest stable dt, from theory and measured on runs"; }

    void declare(CLI::App& app) override {
        scene_.declare(app);
        flag_option(app, "--json", json_, "Print JSON: time steps; 0: unstable at any dt, null: no limit", "Output");
        footer(app, [] { return std::string(limits_examples) + catalogue_hint(); });
    }

    int run() override {
        const std::vector<RunDescription> runs = scene_.descriptions();
        catch_interruptions();
        Progress progress(runs.size(), isatty(STDERR_FILENO) != 0, "steplab limits");
        const StabilityLab lab = lab_of(runs.front(), progress);
        const std::vector<Limit> limits = limits_of(lab, runs, progress);
        progress.clear();
        if (json_) {
            print_data(limits_json(limits));
        } else {
            print(fmt::format("{} in {}: largest ω at the start {:.6g} 1/s\n\n{}{}", shown(runs.front().model),
                              id(runs.front().precision), lab.omega_max(), limits_table(limits, runs.front().dt),
                              explained));
        }
        return static_cast<int>(ExitCode::done);
    }

private:
    static StabilityLab lab_of(const RunDescription& run, Progress& progress) {
        const Watching watching([&] { progress.stage("finding the largest frequency of the scene"); });
        return StabilityLab(run);
    }

    static std::vector<Limit> limits_of(const StabilityLab& lab, const std::vector<RunDescription>& runs,
                                        Progress& progress) {
        if (runs.size() == 1) {
            const Watching watching([&] { progress.stage("measuring the limit of " + runs.front().method); });
            return {lab.limit(runs.front())};
        }
        return all_limits(lab, runs, [&](std::size_t found) { progress.at(found); });
    }

    SceneOptions scene_{SceneOptions::Methods::one_or_all};
    bool json_ = false;
};

}  // namespace

std::unique_ptr<Command> limits_command() { return std::make_unique<LimitsCommand>(); }

}  // namespace steplab
