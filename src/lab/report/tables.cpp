#include "lab/report/tables.hpp"

#include "core/duration.hpp"
#include "core/number_text.hpp"
#include "lab/report/page.hpp"
#include "lab/report/table.hpp"
#include "lab/study/answers.hpp"
#include "sim/catalogue.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace steplab {

namespace {

std::optional<std::size_t> colour_of(const std::string& method, const MethodColours& colours) {
    const auto found = colours.find(method);
    return found == colours.end() ? std::nullopt : std::optional(found->second);
}

std::string answer_cell(const Measurement* best, const MethodColours& colours) {
    if (!best) return "–";
    return fmt::format("{}<br><small>{}, {}<br>{}</small>",
                       method_name(best->run.method, colour_of(best->run.method, colours)), step_text(best->run),
                       id(best->run.precision), duration_text(*best->wall_seconds));
}

std::string order_cell(const std::optional<double>& order) { return order ? fmt::format("{:.2f}", *order) : "–"; }

std::string own_order(const Study& study, const MethodInfo& info) {
    if (info.adaptive) return "adaptive";
    return std::to_string(order_of(with_method(study.plan.scene, info.id)));
}

/// "0.71689", "unstable at any dt", "stable at any dt".
std::string limit_cell(const std::optional<double>& dt) {
    if (!dt) return "–";
    if (*dt == 0) return "unstable at any dt";
    return std::isinf(*dt) ? "stable at any dt" : fmt::format("{:.5g}", *dt);
}

}  // namespace

std::string answers_table(std::span<const Study> studies, std::span<const double> errors,
                          const MethodColours& colours) {
    Table table{{"scene"}, {}};
    for (const double error : errors) table.head.push_back("error ≤ " + readable(error));
    for (const Study& study : studies) {
        std::vector<std::string> row{fmt::format("<a href=\"#{0}\">{0}</a><br><small>to t = {1} s</small>",
                                                 escaped(study.plan.scene.model), readable(study.plan.time, 4))};
        for (const double error : errors) row.push_back(answer_cell(fastest(study.runs, error), colours));
        table.rows.push_back(std::move(row));
    }
    return html_of_markup(table);
}

std::string answers_in_words(const Study& study, std::span<const double> errors) {
    std::string text = "<ul>\n";
    for (std::size_t first = 0; first < errors.size();) {
        const std::string said = answer(study.runs, errors[first]);
        std::size_t last = first;
        while (last + 1 < errors.size() && answer(study.runs, errors[last + 1]) == said) ++last;
        text += fmt::format("<li>For an error of {}{}: {}.</li>\n", typed(errors[first]),
                            last > first ? " to " + typed(errors[last]) : "", said);
        first = last + 1;
    }
    return text + "</ul>\n";
}

std::string pareto_table(const Study& study, const MethodColours& colours) {
    Table table{{"error [m]", "wall time", "method", "step size", "precision", "force evaluations", "RMS error [m]",
                 "energy error [J]"},
                {}};
    for (const Measurement* run : pareto_front(study.runs)) {
        table.rows.push_back({readable(run->error), duration_text(*run->wall_seconds),
                              method_name(run->run.method, colour_of(run->run.method, colours)), step_text(run->run),
                              std::string(id(run->run.precision)), grouped(run->result.evaluations),
                              readable(run->rms_error), readable(run->result.energy_error)});
    }
    return html_of_markup(table);
}

std::string orders_table(const Study& study) {
    Table table{{"method", "order"}, {}};
    for (const Precision precision : study.plan.precisions) table.head.push_back(fmt::format("in {}", id(precision)));
    table.head.insert(table.head.end(), {"runs", "of these diverged"});
    for (const std::string& id : study.plan.methods) {
        const auto of_it = [&](const Measurement& run) { return run.run.method == id; };
        const auto failed = [&](const Measurement& run) { return of_it(run) && run.diverged(); };
        const auto runs = std::count_if(study.runs.begin(), study.runs.end(), of_it);
        std::vector<std::string> row{method_name(id), own_order(study, method(id).info)};
        for (const Precision precision : study.plan.precisions)
            row.push_back(order_cell(measured_order(study.runs, id, precision)));
        const bool given_up = std::any_of(study.cut.begin(), study.cut.end(),
                                          [&](const CutSeries& series) { return series.method == id; });
        row.push_back(runs > 0 ? std::to_string(runs) : given_up ? "takes too long" : "cannot run it");
        row.push_back(std::to_string(std::count_if(study.runs.begin(), study.runs.end(), failed)));
        table.rows.push_back(std::move(row));
    }
    return html_of_markup(table);
}

std::string limits_table(const Study& study) {
    Table table{{"method", "by theory [s]", "measured [s]", "note"}, {}};
    for (const Limit& limit : study.limits) {
        table.rows.push_back({method_name(limit.description.method), limit_cell(limit.theory),
                              limit_cell(limit.measured), escaped(limit.note)});
    }
    return html_of_markup(table);
}

}  // namespace steplab
