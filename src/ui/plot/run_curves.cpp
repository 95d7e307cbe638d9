#include "ui/plot/run_curves.hpp"

#include "session/run_name.hpp"

#include <algorithm>
#include <utility>

namespace steplab::ui {

plot::Curve over_time(std::string name, std::size_t colour, const SampleSeries& series, const SampleValue& value) {
    plot::Curve curve{.name = std::move(name), .colour = colour};
    for (const Sample& sample : series.samples) {
        curve.x.push_back(sample.time);
        curve.y.push_back(value(sample));
    }
    if (curve.x.size() > 1 && curve.x.front() > curve.x.back()) {
        std::reverse(curve.x.begin(), curve.x.end());
        std::reverse(curve.y.begin(), curve.y.end());
    }
    return curve;
}

std::string name_of_run(const Context& context, std::size_t run) {
    if (context.session.followers.empty()) return "run";
    return run_name(context.run(run).description, context.view.description);
}

void add_runs(plot::Plot& plot, const Context& context, const SampleValue& value) {
    for (std::size_t run = 0; run <= context.session.followers.size(); ++run) {
        const RunView& view = context.run(run);
        if (view.series.samples.empty()) continue;  // until it has taken the first one
        plot.curves.push_back(over_time(name_of_run(context, run), view.swatch, view.series, value));
        plot.curves.back().line = plot::line_of_run(view.swatch);
    }
}

}  // namespace steplab::ui
