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

constexpr const char* what_it_is =
    "Which method, at which step, in which precision, gives an accuracy in the least time? Every method ran every "
    "scene "
    "with ever smaller steps; each run was compared with a reference and timed.";

constexpr const char* answers_explained =
    "<p>The fastest run whose error at the end was no larger: its method, step (<em>dt</em>, or the <em>tolerance</em> "
    "of "
    "a method that chooses its own steps), precision and time. The error is the largest distance of a particle from "
    "where it should be. A dash: no run was that accurate.</p>\n";

constexpr const char* times_explained =
    "<p class=\"quiet\">Times are of the stepping alone, the least of several rounds in which all runs take turns, on "
    "one "
    "core. Compare them with each other, not with those of another machine. Runs that blew up are counted, but never "
    "drawn or ranked.</p>\n";

constexpr const char* diagrams_explained =
    "<p>Each dot is a run. Further down is more accurate, further left is faster: the best methods run along the lower "
    "left edge. A line that flattens at the bottom has reached the last digits of its precision, or of the reference. "
    "Coloured are the methods that are fastest at some error, and rk4 to compare with; point at a grey line or at a "
    "name "
    "to bring it forward.</p>\n";

constexpr const char* energy_explained =
    "<p>Methods of fixed steps, each at the run whose cost is nearest to the middle of all: the largest energy error "
    "within each sixtieth of the time. A level line keeps the energy within bounds for ever, a rising one does "
    "not.</p>\n";

constexpr const char* orders_explained =
    "<p>Halving dt makes the error 2<sup>order</sup> times smaller: by theory, and by the slope between the two finest "
    "runs that are clear of rounding. A dash: no two such runs.</p>\n";

constexpr const char* limits_explained =
    "<p>The largest dt at which a small vibration does not grow: by theory, from the scene's highest frequency, and by "
    "bisection on runs. Above it every error grows without bound.</p>\n";

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
    for (const Study& study : studies) text += fmt::format("<a href=\"#{0}\">{0}</a>", study.plan.scene.model);
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

std::string diagrams(const StudyFigures& figures, std::span<const std::string> svg) {
    std::string text = "<div class=\"diagrams\">\n";
    for (std::size_t i = 0; i + 1 < svg.size(); ++i) text += captioned(figures.captions[i], svg[i]);
    return text + "</div>\n";
}

std::string reference_text(const Study& study) {
    return fmt::format("<p class=\"quiet\">Judged by: {}, known to {}. No error is given below that.</p>\n",
                       escaped(study.reference), readable(study.reference_error));
}

/// The methods whose series in this precision was cut, in words; empty if none was.
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
        "steps gain no more.",
        duration_text(study.plan.most_seconds_a_run));
    for (const Precision precision : study.plan.precisions) text += cut_in(study, precision);
    return text + "</p>\n";
}

std::string study_section(const Study& study, std::span<const double> errors, const StudyFigures& figures,
                          std::span<const std::string> svg, const MethodColours& colours) {
    const RunDescription& scene = study.plan.scene;
    std::string text =
        fmt::format("<section>\n<h2 id=\"{0}\">{0}</h2>\n<p>{1} To t = {2}{3}.</p>\n", scene.model,
                    escaped(model(scene.model).info.what), number_text(study.plan.time), scene_text(scene));
    text += answers_in_words(study, errors) + reference_text(study);
    if (const std::string chaos = chaos_note(scene, study.plan.time, study.reference_error); !chaos.empty())
        text += fmt::format("<p><strong>{}</strong></p>\n", chaos);
    text += std::string("<h3>Error against cost</h3>\n") + diagrams_explained + diagrams(figures, svg) +
            legend(study, colours) + cut_text(study);
    text +=
        "<h3>The best that can be had</h3>\n<p>No other run is both faster and more accurate than one of these (the "
        "Pareto front).</p>\n" +
        pareto_table(study, colours);
    text += std::string("<h3>Energy</h3>\n") + energy_explained + "<div class=\"diagrams\">\n" +
            captioned(figures.captions.back(), svg.back()) + "</div>\n";
    text += std::string("<div class=\"columns\"><div><h3>Orders</h3>\n") + orders_explained + orders_table(study);
    text += std::string("</div><div><h3>Stability</h3>\n") + limits_explained + limits_table(study) + "</div></div>\n";
    return text + "</section>\n";
}

}  // namespace

std::string report_page(const std::vector<Study>& studies, std::span<const double> errors, const Circumstances& made) {
    const MethodColours colours = method_colours(studies);
    std::vector<StudyFigures> of_study;
    std::vector<Figure> figures;
    for (const Study& study : studies) {
        of_study.push_back(study_figures(study, colours));
        figures.insert(figures.end(), of_study.back().figures.begin(), of_study.back().figures.end());
    }
    const std::vector<std::string> svg = svg_figures(figures);
    std::string page = page_head("Speed against error", what_it_is, made) + links(studies) + "<h2>Answers</h2>\n" +
                       answers_explained + answers_table(studies, errors, colours) + times_explained;
    std::size_t used = 0;
    for (std::size_t i = 0; i < studies.size(); ++i) {
        const std::size_t count = of_study[i].figures.size();
        page += study_section(studies[i], errors, of_study[i], std::span(svg).subspan(used, count), colours);
        used += count;
    }
    return page + page_end;
}

}  // namespace steplab
