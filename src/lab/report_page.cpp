#include "lab/report_page.hpp"

#include "core/text.hpp"
#include "lab/answers.hpp"
#include "lab/lyapunov.hpp"
#include "lab/page.hpp"
#include "sim/catalogue.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace steplab {

namespace {

/// Seconds as one reads them.
std::string duration(double seconds) {
    if (seconds < 1e-3) return fmt::format("{:.3g} µs", seconds * 1e6);
    if (seconds < 1) return fmt::format("{:.3g} ms", seconds * 1e3);
    return fmt::format("{:.3g} s", seconds);
}

std::string scene_text(const RunDescription& scene) {
    std::string text;
    for (const auto& info : scene.scene.infos()) {
        if (scene.scene[info.name] != info.default_value)
            text += fmt::format(", {} = {}", info.name, format_value(info, scene.scene[info.name]));
    }
    return text;
}

enum class Against { time, evaluations };

/// Error against time or evaluations: a curve for each method and precision.
Figure work_precision(const Study& study, Against against) {
    Figure figure{.x_label = against == Against::time ? "time of the run [s]" : "evaluations of the force",
                  .y_label = "error at the end",
                  .curves = {}};
    for (std::size_t i = 0; i < study.plan.methods.size(); ++i) {
        for (const Precision precision : study.plan.precisions) {
            const bool in_float = precision == Precision::float_;
            Curve curve{.name = in_float ? "" : study.plan.methods[i],
                        .points = {},
                        .colour = static_cast<int>(i),
                        .dashed = in_float};
            if (study.plan.precisions.size() == 1) curve.name = study.plan.methods[i];
            for (const Measurement& run : study.runs) {
                if (run.run.method != study.plan.methods[i] || run.run.precision != precision || run.diverged) continue;
                const double cost =
                    against == Against::time ? run.wall_seconds.value_or(0) : static_cast<double>(run.evaluations);
                curve.points.emplace_back(cost, run.error);
            }
            if (!curve.points.empty()) figure.curves.push_back(std::move(curve));
        }
    }
    return figure;
}

double middling_cost(const Study& study) {
    std::vector<std::uint64_t> costs;
    for (const Measurement& run : study.runs) {
        if (!run.diverged) costs.push_back(run.evaluations);
    }
    if (costs.empty()) return 1;
    std::nth_element(costs.begin(), costs.begin() + static_cast<std::ptrdiff_t>(costs.size() / 2), costs.end());
    return static_cast<double>(costs[costs.size() / 2]);
}

std::vector<Figure> figures_of(const Study& study) {
    return {work_precision(study, Against::time), work_precision(study, Against::evaluations),
            Figure{.x_label = "time in the scene",
                   .y_label = "|energy error|",
                   .log_x = false,
                   .curves = energy_curves(study, middling_cost(study))}};
}

std::string answers_table(std::span<const Study> studies, std::span<const double> errors) {
    std::string text = "<table><tr><th>scene</th>";
    for (const double error : errors) text += fmt::format("<th>error ≤ {:.0e}</th>", error);
    text += "</tr>\n";
    for (const Study& study : studies) {
        text += fmt::format("<tr><td><a href=\"#{0}\">{0}</a></td>", study.plan.scene.model);
        for (const double error : errors) {
            const Measurement* best = fastest(study.runs, error);
            text += best ? fmt::format("<td>{}<br><span class=\"quiet\">{}, {}, {}</span></td>", best->run.method,
                                       step_text(best->run), id(best->run.precision), duration(*best->wall_seconds))
                         : std::string("<td>–</td>");
        }
        text += "</tr>\n";
    }
    return text + "</table>\n";
}

std::string answers_in_words(const Study& study, std::span<const double> errors) {
    std::string text = "<ul>\n";
    for (const double error : errors)
        text += fmt::format("<li>For {:.0e}: {}.</li>\n", error, answer(study.runs, error));
    return text + "</ul>\n";
}

std::string pareto_table(const Study& study) {
    std::string text =
        "<table><tr><th>error</th><th>time</th><th>method</th><th>step</th><th>precision</th><th>evaluations</th>"
        "<th>energy error</th></tr>\n";
    for (const Measurement* run : pareto_front(study.runs)) {
        text += fmt::format(
            "<tr><td>{:.2e}</td><td>{}</td><td>{}</td><td>{}</td><td>{}</td><td>{}</td><td>{:.1e}</td></tr>\n",
            run->error, duration(*run->wall_seconds), run->run.method, step_text(run->run), id(run->run.precision),
            run->evaluations, run->energy_error);
    }
    return text + "</table>\n";
}

std::string order_cell(const std::optional<double>& order) { return order ? fmt::format("{:.2f}", *order) : "–"; }

std::string methods_table(const Study& study) {
    std::string text =
        "<table><tr><th>method</th><th>order</th><th>measured</th><th>in float</th><th>runs</th>"
        "<th>diverged</th></tr>\n";
    for (const std::string& id : study.plan.methods) {
        const auto count = [&](bool diverged) {
            return std::count_if(study.runs.begin(), study.runs.end(), [&](const Measurement& run) {
                return run.run.method == id && run.diverged == diverged;
            });
        };
        const MethodInfo& info = method(id).info;
        text += fmt::format("<tr><td>{}</td><td>{}</td><td>{}</td><td>{}</td><td>{}</td><td>{}</td></tr>\n", id,
                            info.adaptive ? std::string("adaptive") : std::to_string(info.order),
                            order_cell(measured_order(study.runs, id, Precision::double_)),
                            order_cell(measured_order(study.runs, id, Precision::float_)), count(false), count(true));
    }
    return text + "</table>\n";
}

std::string study_section(const Study& study, std::span<const double> errors, std::span<const std::string> svg) {
    const RunDescription& scene = study.plan.scene;
    std::string text = fmt::format("<h2 id=\"{0}\">{0}</h2>\n<p>{1} To t = {2}{3}.</p>\n", scene.model,
                                   model(scene.model).info.what, number_text(study.plan.time), scene_text(scene));
    text += answers_in_words(study, errors);
    text += "<div class=\"row\">\n" + captioned("Error against time (dashed: float)", svg[0]) +
            captioned("Error against evaluations (dashed: float)", svg[1]) + "</div>\n";
    text += fmt::format("<p class=\"quiet\">Reference: {}; its own error is {:.1e}. No error is given below it.</p>\n",
                        study.reference.how, study.reference.moments.back().error);
    if (const std::string chaos = chaos_note(scene, study.reference); !chaos.empty())
        text += fmt::format("<p><strong>{}</strong></p>\n", chaos);
    text += "<h3>Nothing measured is both faster and more accurate</h3>\n" + pareto_table(study);
    text += "<div class=\"row\">\n" + captioned("Energy error over time, at about equal cost, double", svg[2]) +
            "<div><h3>Orders as this scene shows them</h3>\n" + methods_table(study) + "</div></div>\n";
    return text;
}

}  // namespace

std::string report_page(std::span<const Study> studies, std::span<const double> errors, const Circumstances& made) {
    std::vector<Figure> figures;
    for (const Study& study : studies) {
        for (Figure& figure : figures_of(study)) figures.push_back(std::move(figure));
    }
    const std::vector<std::string> svg = svg_figures(figures);
    std::string page = page_head("Speed against error", made) + answers_table(studies, errors);
    for (std::size_t i = 0; i < studies.size(); ++i)
        page += study_section(studies[i], errors, std::span(svg).subspan(3 * i, 3));
    return page + page_end;
}

}  // namespace steplab
