#include "lab/study/answers.hpp"

#include "core/number_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace steplab {

namespace {

bool counts(const Measurement& run) { return !run.diverged() && run.wall_seconds && std::isfinite(run.error); }

}  // namespace

const Measurement* fastest(std::span<const Measurement> runs, double error, std::string_view method) {
    const Measurement* best = nullptr;
    for (const Measurement& run : runs) {
        if (!counts(run) || run.error > error || (!method.empty() && run.run.method != method)) continue;
        if (!best || *run.wall_seconds < *best->wall_seconds) best = &run;
    }
    return best;
}

std::vector<const Measurement*> pareto_front(std::span<const Measurement> runs) {
    std::vector<const Measurement*> front;
    for (const Measurement& run : runs) {
        if (counts(run)) front.push_back(&run);
    }
    std::sort(front.begin(), front.end(), [](const Measurement* a, const Measurement* b) {
        return std::pair(*a->wall_seconds, a->error) < std::pair(*b->wall_seconds, b->error);
    });
    double least = infinity;
    std::erase_if(front, [&](const Measurement* run) {
        const bool beaten = run->error >= least;
        least = std::min(least, run->error);
        return beaten;
    });
    return front;
}

std::string step_text(const RunDescription& run) {
    if (chooses_its_steps(run)) return "tolerance " + typed(run.method_parameters["tolerance"]);
    return "dt " + typed(run.dt, 3);
}

std::string answer(std::span<const Measurement> runs, double error) {
    const Measurement* best = fastest(runs, error);
    if (!best) return "no run reached this error";
    std::string text = fmt::format("{} at {} in {}", best->run.method, step_text(best->run), id(best->run.precision));
    const Measurement* classic = fastest(runs, error, "rk4");
    if (best->run.method == "rk4") return text;
    if (!classic) return text + "; rk4 does not reach this error";
    return text + fmt::format(", {} times faster than rk4", readable(*classic->wall_seconds / *best->wall_seconds));
}

std::optional<double> measured_order(std::span<const Measurement> runs, std::string_view method, Precision precision) {
    std::vector<const Measurement*> series;
    for (const Measurement& run : runs) {
        if (run.run.method == method && run.run.precision == precision && !run.diverged() &&
            !chooses_its_steps(run.run))
            series.push_back(&run);
    }
    if (series.size() < 3) return std::nullopt;
    const auto by_error = [](const Measurement* a, const Measurement* b) { return a->error < b->error; };
    const double floor = 30 * (*std::min_element(series.begin(), series.end(), by_error))->error;
    const double ceiling = 0.1 * (*std::max_element(series.begin(), series.end(), by_error))->error;
    for (std::size_t i = series.size() - 1; i > 0; --i) {
        const Measurement &coarse = *series[i - 1], &fine = *series[i];
        if (fine.error > floor && coarse.error < ceiling && coarse.error > fine.error && fine.run.dt < coarse.run.dt)
            return std::log(coarse.error / fine.error) / std::log(coarse.run.dt / fine.run.dt);
    }
    return std::nullopt;
}

}  // namespace steplab
