#include "app/command_limits.hpp"

#include "app/catalogue_text.hpp"
#include "app/command_line.hpp"
#include "app/limits_text.hpp"
#include "app/progress.hpp"
#include "app/scene_options.hpp"
#include "core/error.hpp"
#include "io/interruption.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <unistd.h>

namespace steplab {

namespace {

constexpr const char* examples =
    "Examples:\n"
    "  steplab limits --model chain --method all\n"
    "  steplab limits --model rope --set c=3 --method rk4 --json\n\n";

constexpr const char* explained =
    "\nThe largest dt at which a small vibration does not grow: by theory, from ω, and measured on runs.\n";

class LimitsCommand final : public Command {
public:
    std::string_view name() const override { return "limits"; }
    std::string_view what() const override { return "Find the largest stable dt, by theory and by runs"; }

    void declare(CLI::App& app) override {
        scene_.declare(app);
        app.add_flag("--json", json_, "As JSON: time steps; 0: unstable at any dt, null: no limit")->group("Output");
        app.footer([] { return std::string(examples) + catalogue_help(); });
    }

    int run() override {
        const std::vector<RunDescription> runs = scene_.descriptions();
        catch_interruptions();
        const StabilityLab lab(runs.front());
        std::vector<Limit> limits;
        Progress progress(runs.size(), isatty(STDERR_FILENO) != 0);
        for (const RunDescription& run : runs) {
            progress.at(limits.size());
            limits.push_back(runs.size() == 1 ? lab.limit(run) : limit_or_refusal(lab, run));
        }
        progress.clear();
        if (json_) {
            print(limits_json(limits));
        } else {
            print(fmt::format("{} in {}: largest ω at the start {:.9g}\n\n{}{}", runs.front().model,
                              id(runs.front().precision), lab.omega_max(), limits_table(limits, runs.front().dt),
                              explained));
        }
        return static_cast<int>(ExitCode::done);
    }

private:
    /// A method that cannot do the scene is no reason to tell nothing of the others.
    static Limit limit_or_refusal(const StabilityLab& lab, const RunDescription& run) {
        try {
            return lab.limit(run);
        } catch (const UsageError& refusal) {
            return {
                .description = run, .omega_max = lab.omega_max(), .theory = {}, .measured = {}, .note = refusal.what()};
        }
    }

    SceneOptions scene_{SceneOptions::Methods::one_or_all};
    bool json_ = false;
};

}  // namespace

std::unique_ptr<Command> limits_command() { return std::make_unique<LimitsCommand>(); }

}  // namespace steplab
