#include "app/commands/advise.hpp"

#include "app/cli/command_line.hpp"
#include "app/cli/progress.hpp"
#include "app/cli/scene_options.hpp"
#include "app/cli/standard_streams.hpp"
#include "app/cli/text_table.hpp"
#include "core/duration.hpp"
#include "core/error.hpp"
#include "core/interruption.hpp"
#include "core/number_text.hpp"
#include "core/shown.hpp"
#include "core/text.hpp"
#include "lab/study/advice.hpp"
#include "lab/study/answers.hpp"
#include "lab/study/study.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <unistd.h>

namespace steplab {

namespace {

constexpr ParameterInfo error_info{
    .name = "--error", .unit = "", .minimum_included = false, .what = "largest allowed error at the end"};

/// Rows of the table of other methods, at most.
constexpr std::size_t most_others = 5;

/// "12 times as fast as rk4 at dt 0.0021".
std::string against_rk4(const Advice& advice) {
    if (advice.best.run.method == "rk4") return "";
    for (const Measurement& other : advice.others) {
        if (other.run.method != "rk4") continue;
        return fmt::format("  {} times as fast as rk4, which needs {} and {}\n",
                           readable(*other.wall_seconds / *advice.best.wall_seconds), step_text(other.run),
                           duration_text(*other.wall_seconds));
    }
    return "  rk4 did not reach this error\n";
}

std::string others_table(const Advice& advice) {
    if (advice.others.empty()) return "";
    std::vector<Row> rows{{"NEXT BEST", "STEP", "PRECISION", "TIME", "RELATIVE TIME"}};
    for (std::size_t i = 0; i < std::min(advice.others.size(), most_others); ++i) {
        const Measurement& other = advice.others[i];
        rows.push_back({other.run.method, step_text(other.run), std::string(id(other.run.precision)),
                        duration_text(*other.wall_seconds), readable(*other.wall_seconds / *advice.best.wall_seconds)});
    }
    return fmt::format("\n{}", aligned(rows, 2));
}

std::string advice_text(const StudyPlan& plan, double error, const Reference& reference, const Advice& advice) {
    const Measurement& best = advice.best;
    std::string text = fmt::format("{} to t = {} with an error of at most {}: {}, {}, {}\n\n", shown(plan.scene.model),
                                   short_number(plan.time), typed(error), best.run.method, step_text(best.run),
                                   id(best.run.precision));
    text += fmt::format("  steplab run {} --steps {}\n\n", command_line(best.run), best.steps);
    text += fmt::format("  takes about {} ({} force evaluations)\n", duration_text(*best.wall_seconds),
                        best.result.evaluations);
    text += fmt::format("  verified: in a second run its error is {} (reference: {}, accurate to {})\n",
                        typed(best.error), reference.how, typed(reference.moments.back().error));
    return text + against_rk4(advice) + others_table(advice);
}

class AdviseCommand final : public Command {
public:
    std::string_view name() const override { return "advise"; }
    std::string_view what() const override { return "Find the fastest method, dt and precision for a given error"; }

    void declare(CLI::App& app) override {
        scene_.declare(app);
        time_.declare(app);
        text_option(app, "--error", error_, "E", "Largest allowed error of a position at the end [m] (required)");
    }

    int run() override {
        if (error_.empty())
            throw UsageError("--error E is required: the largest allowed error of a position at the end");
        const double error = parse_value(error_info, error_);
        const StudyPlan plan = plan_of(scene_.description());
        catch_interruptions();
        Progress bar(1, isatty(STDERR_FILENO) != 0, "steplab advise");
        const Reference reference = reference_for(plan, error / finer_reference, [&](int run, double part) {
            bar.stage(fmt::format("computing the reference solution: run {}, {:.0f} %", run, std::floor(part * 100)));
        });
        const Advice advice = advise(plan, error, reference, [&](double part) {
            check_interruption();
            bar.at_part(part);
        });
        bar.clear();
        print(advice_text(plan, error, reference, advice));
        return static_cast<int>(ExitCode::done);
    }

private:
    StudyPlan plan_of(const RunDescription& scene) const {
        StudyPlan plan = default_plans(false).front();
        plan.scene = scene;
        plan.time = time_.duration(scene);
        if (scene_.names_method()) plan.methods = {scene.method};
        if (scene_.names_precision()) plan.precisions = {scene.precision};
        for (const auto& info : scene.method_parameters.infos()) {
            if (scene.method_parameters[info.name] != info.default_value)
                plan.method_settings[std::string(info.name)] = scene.method_parameters[info.name];
        }
        return plan;
    }

    SceneOptions scene_;
    TimeOptions time_{1000};
    std::string error_;
};

}  // namespace

std::unique_ptr<Command> advise_command() { return std::make_unique<AdviseCommand>(); }

}  // namespace steplab
