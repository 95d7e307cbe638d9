#include "app/commands/report.hpp"

#include "app/cli/catalogue_text.hpp"
#include "app/cli/command_line.hpp"
#include "app/cli/progress.hpp"
#include "app/cli/scene_options.hpp"
#include "app/cli/standard_streams.hpp"
#include "core/error.hpp"
#include "core/interruption.hpp"
#include "core/number_text.hpp"
#include "core/shown.hpp"
#include "core/text.hpp"
#include "core/watching.hpp"
#include "io/scene_file.hpp"
#include "lab/report/report.hpp"
#include "sim/catalogue.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <unistd.h>
#include <utility>

namespace steplab {

namespace {

constexpr ParameterInfo target_error_info{
    .name = "--error", .unit = "", .minimum_included = false, .what = "target error"};
constexpr ParameterInfo time_info{.name = "--time", .unit = "", .minimum_included = false, .what = "end time"};

constexpr const char* report_examples =
    "Examples:\n"
    "  steplab report --quick --out out\n"
    "  steplab report --scene figure-eight --quick --out eight\n"
    "  steplab report --model chain --set n=100 --time 50 --error 1e-3 --error 1e-9 --out chain\n\n";

class ReportCommand final : public Command {
public:
    std::string_view name() const override { return "report"; }
    std::string_view what() const override {
        return "Measure the time to a given error: a table (CSV) and a page (HTML)";
    }

    void declare(CLI::App& app) override {
        flag_option(app, "--thesis", thesis_, "Write thesis.html instead: tables and charts of the thesis of 2008");
        text_option(app, "--out", out_, "DIR", "Folder for speed_error.csv and report.html (required)");
        flag_option(app, "--quick", quick_, "Fewer and shorter runs: under 1 minute instead of under 15");
        repeated_option(app, "--model", models_, "ID", "Only this model; repeatable (default all)");
        repeated_option(app, "--scene", scenes_, "FILE|NAME", "Only this scene file or shipped scene; repeatable");
        repeated_option(app, "--method", methods_, "ID", "Only this method; repeatable (default all)");
        text_option(app, "--precision", precision_, "float|double", "Only this precision (default both)");
        repeated_option(app, "--set", settings_, "name=value",
                        "Parameter of the models, scenes or methods; repeatable");
        text_option(
            app, "--time", time_, "T",
            "End time of the runs [s] (default: one for each model; the end that a scene file gives, else 1000 steps)");
        repeated_option(app, "--error", errors_, "E", "Target error [m]; repeatable (default 1e-2 ... 1e-12)");
        footer(app, [] { return std::string(report_examples) + catalogue_hint(); });
    }

    int run() override {
        for (const std::string& id : models_) refuse_left_out(model(id).info.id);
        if (out_.empty()) throw UsageError("--out DIR is required: the folder for speed_error.csv and report.html");
        if (thesis_) {
            refuse_beside_thesis();
            catch_interruptions();
            return write_thesis();
        }
        ReportRequest request{.folder = out_, .plans = plans()};
        if (!errors_.empty()) request.errors = errors();
        catch_interruptions();
        Progress bar(1, isatty(STDERR_FILENO) != 0, "steplab report");
        try {
            write_report(request, [&](double part, const std::string&) {
                check_interruption();
                bar.at_part(part);
            });
        } catch (const Interrupted&) {
            bar.clear();
            print_aside(
                fmt::format("steplab report: interrupted; run the same command again to resume (from {}/.measured)\n",
                            shown(out_)));
            throw;
        }
        bar.clear();
        print(fmt::format("wrote {}/speed_error.csv and {}/report.html\n", shown(out_), shown(out_)));
        if (models_.empty() && scenes_.empty()) print_note("steplab report", "not in it: " + left_out_text());
        return static_cast<int>(ExitCode::done);
    }

private:
    /// The thesis has its own scenes, methods and times.
    void refuse_beside_thesis() const {
        const std::pair<bool, const char*> others[] = {
            {quick_, "--quick"},           {!models_.empty(), "--model"},
            {!scenes_.empty(), "--scene"}, {!methods_.empty(), "--method"},
            {!settings_.empty(), "--set"}, {!precision_.empty(), "--precision"},
            {!time_.empty(), "--time"},    {!errors_.empty(), "--error"}};
        for (const auto& [given, name] : others) {
            if (given)
                throw UsageError(
                    fmt::format("--thesis has scenes and methods of its own: it cannot be combined with {}", name));
        }
    }

    static void refuse_left_out(std::string_view id) {
        for (const LeftOut& scene : left_out_of_plans()) {
            if (scene.model == id) throw UsageError(fmt::format("report has no scene of {}: {}", id, scene.reason));
        }
    }

    int write_thesis() const {
        Progress bar(1, isatty(STDERR_FILENO) != 0, "steplab report");
        {
            const Watching watching([&] { bar.stage("computing the tables and charts of the thesis"); });
            write_thesis_page(out_);
        }
        bar.clear();
        print(fmt::format("wrote {}/thesis.html\n", shown(out_)));
        return static_cast<int>(ExitCode::done);
    }

    std::vector<StudyPlan> plans() const {
        for (const std::string& id : methods_) method(id);
        std::vector<StudyPlan> chosen = default_plans(quick_);
        const auto all = static_cast<double>(chosen.size());
        std::erase_if(chosen, [&](const StudyPlan& plan) {
            const bool named = std::find(models_.begin(), models_.end(), plan.scene.model) != models_.end();
            return !named && !(models_.empty() && scenes_.empty());
        });
        for (const std::string& name : scenes_) add(plan_of(name), chosen);
        for (StudyPlan& plan : chosen) {
            // The time of models that are left out is given to the others: an expensive scene needs it to show most
            // methods at their best.
            if (quick_) plan.most_seconds_a_run *= std::max(1.0, all / static_cast<double>(chosen.size()));
            if (!methods_.empty()) plan.methods = methods_;
            if (!precision_.empty()) plan.precisions = {precision_of(precision_)};
            if (!time_.empty()) plan.time = parse_value(time_info, time_);
        }
        for (const Setting& setting : parse_settings(settings_)) apply(setting, chosen);
        for (const StudyPlan& plan : chosen) check(plan.scene);
        return chosen;
    }

    StudyPlan plan_of(const std::string& scene) const {
        const RunDescription run = describe(find_scene(scene));
        constexpr double usual_steps = 1000;
        StudyPlan plan = plan_for(run, model_of(run).opening.until.value_or(usual_steps * run.dt), quick_);
        if (quick_ && time_.empty()) shorten(plan);
        return plan;
    }

    static void shorten(StudyPlan& plan) {
        const double whole = std::exchange(plan.time, quick_time(plan));
        if (plan.time == whole) return;
        print_note("steplab report", fmt::format("{}: over {} s of {} s, as --quick has no more time (--time T)",
                                                 shown(plan.scene.model), typed(plan.time, 3), typed(whole, 3)));
    }

    /// Tables and pages call a scene by the name of its file.
    static void add(StudyPlan plan, std::vector<StudyPlan>& plans) {
        for (const StudyPlan& other : plans) {
            if (other.scene.model == plan.scene.model)
                throw UsageError(fmt::format("two scenes of the report are called '{}'", shown(plan.scene.model)));
        }
        plans.push_back(std::move(plan));
    }

    /// Sets a parameter in all plans whose model or methods have it. Throws UsageError if none has.
    static void apply(const Setting& setting, std::vector<StudyPlan>& plans) {
        bool known = false;
        for (StudyPlan& plan : plans) {
            if (plan.scene.scene.contains(setting.name)) {
                plan.scene.scene.set_text(setting.name, setting.text);
                known = true;
            }
            for (const std::string& id : plan.methods) {
                ParameterValues values(method(id).info.parameters);
                if (!values.contains(setting.name)) continue;
                values.set_text(setting.name, setting.text);
                plan.method_settings[setting.name] = values[setting.name];
                known = true;
            }
        }
        if (!known)
            throw UsageError(fmt::format("no model or method of the report has a parameter '{}'", shown(setting.name)));
    }

    std::vector<double> errors() const {
        std::vector<double> values;
        for (const std::string& text : errors_) values.push_back(parse_value(target_error_info, text));
        std::sort(values.begin(), values.end(), std::greater<>());
        return values;
    }

    std::string out_;
    bool quick_ = false, thesis_ = false;
    std::vector<std::string> models_, scenes_, methods_, settings_, errors_;
    std::string precision_, time_;
};

}  // namespace

std::unique_ptr<Command> report_command() { return std::make_unique<ReportCommand>(); }

}  // namespace steplab
