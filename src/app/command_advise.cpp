#include "app/command_advise.hpp"

#include "app/command_line.hpp"
#include "app/progress.hpp"
#include "app/scene_options.hpp"
#include "core/error.hpp"
#include "core/text.hpp"
#include "io/interruption.hpp"
#include "lab/advice.hpp"
#include "lab/answers.hpp"
#include "lab/study.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <unistd.h>

namespace steplab {

namespace {

constexpr ParameterInfo error_info{
    .name = "--error", .unit = "", .minimum_included = false, .what = "error that is allowed at the end"};

/// A person reads no more than a few.
constexpr std::size_t most_others = 5;

class AdviseCommand final : public Command {
public:
    std::string_view name() const override { return "advise"; }
    std::string_view what() const override { return "Find the fastest method, dt and precision for an error"; }

    void declare(CLI::App& app) override {
        scene_.declare(app);
        time_.declare(app);
        text_option(app, "--error", error_, "E", "Largest error of a particle's position at the end (required)");
    }

    int run() override {
        if (error_.empty()) throw UsageError("--error E is needed: the error of a position that is allowed at the end");
        const double error = parse_value(error_info, error_);
        const StudyPlan plan = plan_of(scene_.description());
        catch_interruptions();
        Progress bar(1000, isatty(STDERR_FILENO) != 0);
        const Reference reference = reference_for(plan);
        const Advice advice = advise(plan, error, reference, [&](double part) {
            check_interruption();
            bar.at(static_cast<std::uint64_t>(part * 1000));
        });
        bar.clear();
        print(text_of(plan, error, reference, advice));
        return static_cast<int>(ExitCode::done);
    }

private:
    StudyPlan plan_of(const RunDescription& scene) const {
        StudyPlan plan = default_plans(false).front();
        plan.scene = scene;
        plan.time = time_.duration(scene);
        for (const auto& info : scene.method_parameters.infos()) {
            if (scene.method_parameters[info.name] != info.default_value)
                plan.method_settings[std::string(info.name)] = scene.method_parameters[info.name];
        }
        return plan;
    }

    static std::string milliseconds(const Measurement& run) {
        return fmt::format("{:.3g} ms", 1e3 * run.wall_seconds.value_or(0));
    }

    static std::string text_of(const StudyPlan& plan, double error, const Reference& reference, const Advice& advice) {
        const Measurement& best = advice.best;
        std::string text = fmt::format("For an error of {} of {} at t = {}:\n", number_text(error), plan.scene.model,
                                       number_text(plan.time));
        text += fmt::format("  {} at {} in {}: {} evaluations, about {}\n", best.run.method, step_text(best.run),
                            id(best.run.precision), best.evaluations, milliseconds(best));
        text += fmt::format("  steplab run {} --steps {}\n", command_line(best.run), best.steps);
        text += fmt::format("  run once more: its error is {:.2e} (reference: {}, known to {:.0e})\n", best.error,
                            reference.how, reference.moments.back().error);
        const std::size_t shown = std::min(advice.others.size(), most_others);
        for (std::size_t i = 0; i < shown; ++i) {
            const Measurement& other = advice.others[i];
            text += fmt::format("  {} {} at {} in {} takes {:.2g} times as long\n", i == 0 ? "next:" : "     ",
                                other.run.method, step_text(other.run), id(other.run.precision),
                                *other.wall_seconds / *best.wall_seconds);
        }
        return text;
    }

    SceneOptions scene_;
    TimeOptions time_{1000};
    std::string error_;
};

}  // namespace

std::unique_ptr<Command> advise_command() { return std::make_unique<AdviseCommand>(); }

}  // namespace steplab
