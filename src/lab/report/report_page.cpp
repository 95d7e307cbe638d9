#include "lab/report/report_page.hpp"

#include "core/duration.hpp"
#include "core/number_text.hpp"
#include "core/text.hpp"
#include "lab/report/figures.hpp"
#include "lab/report/page.hpp"
#include "lab/report/table.hpp"
#include "lab/report/tables.hpp"
#include "lab/study/lyapunov.hpp"
#include "sim/catalogue.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace steplab {

namespace {

constexpr const char* contents =
    "Which method, step size and precision reach a given accuracy in the least time? Every method ran every scene with "
    "decreasing step sizes; each run was compared with a reference solution and timed.";

constexpr const char* answers_explained =
    "<p>For each error, the fastest run that was at least this accurate at the end: method, step size (<em>dt</em>, or "
    "the <em>tolerance</em> of an adaptive method), precision and wall time. The error is the largest distance of a "
    "particle from the reference solution. Dash: no run was that accurate.</p>\n";

constexpr const char* times_explained =
    "<p class=\"quiet\">Times are those of the stepping alone, on one core: the minimum over several interleaved "
    "rounds of all runs. Compare them with each other, not with those of another machine. Runs that blew up are "
    "counted, but not plotted or ranked.</p>\n";

constexpr const char* diagrams_explained =
    "<p>Each dot is a run. Lower is more accurate, further left is faster: the best methods lie along the lower left "
    "edge. A curve that flattens at the bottom is limited by rounding, or by the error of the reference. Methods that "
    "are fastest at some error are coloured, and rk4 for comparison; move the mouse over a grey curve or a name to "
    "highlight it.</p>\n";

constexpr const char* energy_explained =
    "<p>Methods with fixed steps, each for the run whose cost is closest to the median: the largest energy error in "
    "each sixtieth of the time. A level curve is a bounded energy error, a rising one an energy drift.</p>\n";

constexpr const char* orders_explained =
    "<p>Halving dt reduces the error by a factor of 2<sup>order</sup>: by theory, and as measured between the two "
    "finest runs that are not limited by rounding. Dash: there are no two such runs.</p>\n";

constexpr const char* limits_explained =
    "<p>The stability limit: the largest dt at which a small vibration does not grow, by linear theory from the "
    "highest frequency of the scene, and measured by bisection on runs. Above it every error grows without "
    "bound.</p>\n";

std::string scene_text(const RunDescription& scene) {
    std::string text;
    for (const auto& info : scene.scene.infos()) {
        if (scene.scene[info.name] != info.default_value)
            text += fmt::format(", {} = {}", info.name, format_value(info, scene.scene[info.name]));
    }
    return text;
}

std::string links(std::span<const Study> studies) {
    std::string text = "<nav>";
    for (const Study& study : studies) text += fmt::format("<a href=\"#{0}\">{0}</a>", escaped(study.plan.scene.model));
    return text + "</nav>\n";
}

std::string legend(const Study& study, const MethodColours& colours) {
    const std::vector<std::string> coloured = coloured_methods(study);
    std::string text = "<p class=\"legend\">", others;
    for (const std::string& id : study.plan.methods) {
        const bool has_colour = std::find(coloured.begin(), coloured.end(), id) != coloured.end();
        (has_colour ? text : others) +=
            method_name(id, has_colour ? std::optional(colours.at(id)) : std::nullopt) + " ";
    }
    return text + (others.empty() ? "" : "<span class=\"quiet\">grey: " + others + "</span>") + "</p>\n";
}

/// All but the last, which has a section of its own.
std::string diagrams(const StudyFigures& all) {
    std::string text = "<div class=\"diagrams\">\n";
    for (std::size_t i = 0; i + 1 < all.figures.size(); ++i) text += captioned(all.captions[i], all.figures[i]);
    return text + "</div>\n";
}

std::string reference_text(const Study& study) {
    return fmt::format("<p class=\"quiet\">Reference: {}, accurate to {} m. No smaller error is reported.</p>\n",
                       escaped(study.reference), readable(study.reference_error));
}

/// The methods whose series in this precision was cut by time, in words; empty if there are none.
std::string cut_in(const Study& study, Precision precision) {
    std::string names;
    for (const CutSeries& series : study.cut) {
        if (series.precision == precision) names += (names.empty() ? " " : ", ") + method_name(series.method);
    }
    return names.empty() ? "" : fmt::format(" In {}:{}.", id(precision), names);
}

std::string cut_text(const Study& study) {
    if (study.cut.empty()) return "";
    std::string text = fmt::format(
        "<p class=\"quiet\">Some curves end because their next run would have taken more than {}, not because smaller "
        "steps bring no further gain.",
        duration_text(study.plan.most_seconds_a_run));
    for (const Precision precision : study.plan.precisions) text += cut_in(study, precision);
    return text + "</p>\n";
}

std::string study_section(const Study& study, std::span<const double> errors, const MethodColours& colours) {
    const StudyFigures all = study_figures(study, colours);
    const RunDescription& scene = study.plan.scene;
    std::string text = fmt::format("<section>\n<h2 id=\"{0}\">{0}</h2>\n<p>{1} Simulated until t = {2} s{3}.</p>\n",
                                   escaped(scene.model), escaped(model_of(scene).info.what),
                                   number_text(study.plan.time), scene_text(scene));
    text += answers_in_words(study, errors) + reference_text(study);
    if (const std::string chaos = chaos_note(scene, study.plan.time, study.reference_error); !chaos.empty())
        text += fmt::format("<p><strong>{}</strong></p>\n", chaos);
    text += std::string("<h3>Error against cost</h3>\n") + diagrams_explained + diagrams(all) + legend(study, colours) +
            cut_text(study);
    text += "<h3>Pareto front</h3>\n<p>No other run is both faster and more accurate than any of these.</p>\n" +
            pareto_table(study, colours);
    text += std::string("<h3>Energy</h3>\n") + energy_explained + "<div class=\"diagrams\">\n" +
            captioned(all.captions.back(), all.figures.back()) + "</div>\n";
    text += std::string("<div class=\"columns\"><div><h3>Orders</h3>\n") + orders_explained + orders_table(study);
    text += std::string("</div><div><h3>Stability</h3>\n") + limits_explained + limits_table(study) + "</div></div>\n";
    return text + "</section>\n";
}

/// Of a page of several scenes.
std::string left_out_of(const std::vector<Study>& studies) {
    if (studies.size() < 2) return "";
    return fmt::format("<p class=\"quiet\">Not in this report: {}.</p>\n", escaped(left_out_text()));
}

}  // namespace

std::string report_page(const std::vector<Study>& studies, std::span<const double> errors, const Circumstances& made) {
    const MethodColours colours = method_colours(studies);
    std::string page = page_head("Speed against error", contents, made) + links(studies) + "<h2>Answers</h2>\n" +
                       answers_explained + answers_table(studies, errors, colours) + times_explained +
                       left_out_of(studies);
    for (const Study& study : studies) page += study_section(study, errors, colours);
    return page + page_end;
}

}  // namespace steplab
