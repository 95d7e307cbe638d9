#include "lab/speed_error.hpp"

#include "core/error.hpp"
#include "lab/gain_watch.hpp"
#include "lab/linearised.hpp"
#include "sim/catalogue.hpp"

#include <algorithm>
#include <cmath>

namespace steplab {

namespace {

/// Runs shorter than this are repeated within a round until they have taken as long together.
constexpr double least_seconds = 2e-4;

/// What one run costs before it is made, from the one made last.
class CostWatch {
public:
    explicit CostWatch(double most_seconds) : most_(most_seconds) {}

    bool too_long(std::uint64_t steps) const { return seconds_a_step_ * static_cast<double>(steps) > most_; }
    void ran(std::uint64_t steps, double seconds) { seconds_a_step_ = seconds / static_cast<double>(steps); }

private:
    double most_;
    double seconds_a_step_ = 0;
};

class Series {
public:
    Series(const StudyPlan& plan, const Reference& reference, std::vector<Measurement>& out)
        : plan_(plan), reference_(reference), out_(out) {}

    void over_dt(const std::string& method, Precision precision) {
        GainWatch gain;
        CostWatch cost(plan_.most_seconds_a_run);
        for (double wanted = static_cast<double>(fewest_steps(plan_, method)); wanted < 1e9; wanted *= plan_.ratio) {
            const auto steps = static_cast<std::uint64_t>(std::ceil(wanted));
            if (cost.too_long(steps)) return;
            const RunDescription run = run_over(plan_, method, precision, steps);
            cost.ran(steps, stepping_seconds(run, steps));
            out_.push_back(measure(run, steps, reference_));
            if (gain.gains_no_more(out_.back())) return;
        }
    }

    void over_tolerance(const std::string& method, Precision precision) {
        GainWatch gain;
        const double least = precision == Precision::float_ ? 1e-8 : 1e-16;
        for (double tolerance = 1e-2; tolerance > least; tolerance /= 10) {
            RunDescription run = run_over(plan_, method, precision, 1);
            run.method_parameters.set("tolerance", tolerance);
            if (stepping_seconds(run, 1) > plan_.most_seconds_a_run) return;
            out_.push_back(measure(run, 1, reference_));
            if (gain.gains_no_more(out_.back())) return;
        }
    }

private:
    const StudyPlan& plan_;
    const Reference& reference_;
    std::vector<Measurement>& out_;
};

/// The scene's largest angular frequency, or one that lets a tenth of the time be a quarter of its period.
double frequency(const StudyPlan& plan) {
    const Model& scene = model(plan.scene.model);
    const LinearisedScene linearised(scene.scene(plan.scene.scene), scene.shape(plan.scene.scene));
    const double omega = highest_frequency(modes(linearised));
    return omega > 0 ? omega : 5 * 3.14159265358979 / plan.time;
}

double time_once(const Measurement& run) {
    double least = infinity, sum = 0;
    while (sum < least_seconds) {
        const double seconds = stepping_seconds(run.run, run.steps);
        least = std::min(least, seconds);
        sum += seconds;
    }
    return least;
}

}  // namespace

Reference reference_for(const StudyPlan& plan) {
    RunDescription scene = plan.scene;
    scene.precision = Precision::double_;
    return reference(scene, std::vector{plan.time});
}

RunDescription run_over(const StudyPlan& plan, const std::string& method, Precision precision, std::uint64_t steps) {
    RunDescription run = with_method(plan.scene, method);
    for (const auto& [name, value] : plan.method_settings) {
        if (run.method_parameters.contains(name)) run.method_parameters.set(name, value);
    }
    run.precision = precision;
    run.dt = plan.time / static_cast<double>(steps);
    return run;
}

bool takes_dt(const std::string& method) { return !steplab::method(method).info.adaptive; }

bool takes_tolerance(const std::string& method) {
    return ParameterValues(steplab::method(method).info.parameters).contains("tolerance");
}

std::uint64_t fewest_steps(const StudyPlan& plan, const std::string& method) {
    const RunDescription run = run_over(plan, method, Precision::double_, 1);
    const double limit = linear_limit(steplab::method(method).info, run.method_parameters);
    const double phase = limit == 0 ? 0.5 : std::min(0.95 * limit, 20.0);
    return static_cast<std::uint64_t>(std::max(1.0, std::ceil(plan.time * frequency(plan) / phase)));
}

std::vector<std::string> possible_methods(const StudyPlan& plan) {
    std::vector<std::string> possible;
    for (const std::string& id : plan.methods) {
        try {
            check(run_over(plan, id, Precision::double_, 1));
            possible.push_back(id);
        } catch (const UsageError&) {
        }
    }
    return possible;
}

void time_interleaved(std::vector<Measurement>& runs, int rounds, const StudyProgress& progress) {
    for (int round = 0; round < rounds; ++round) {
        for (std::size_t i = 0; i < runs.size(); ++i) {
            if (runs[i].diverged) continue;
            runs[i].wall_seconds = std::min(runs[i].wall_seconds.value_or(infinity), time_once(runs[i]));
            progress((round + static_cast<double>(i) / static_cast<double>(runs.size())) / rounds);
        }
    }
}

void go_on_with_series(const StudyPlan& plan, const Reference& reference, SeriesState& state,
                       const std::function<void()>& keep, const StudyProgress& progress) {
    Series series(plan, reference, state.runs);
    const std::vector<std::string> methods = possible_methods(plan);
    const std::size_t all = methods.size() * plan.precisions.size();
    const double share = 2.0 / (2 + plan.rounds);  // a run is made twice, then once a round
    while (state.series < all) {
        const std::string& id = methods[state.series / plan.precisions.size()];
        const Precision precision = plan.precisions[state.series % plan.precisions.size()];
        progress(share * static_cast<double>(state.series) / static_cast<double>(all));
        if (takes_dt(id)) series.over_dt(id, precision);
        if (takes_tolerance(id)) series.over_tolerance(id, precision);
        ++state.series;
        keep();
    }
    if (!state.timed)
        time_interleaved(state.runs, plan.rounds, [&](double part) { progress(share + (1 - share) * part); });
    state.timed = true;
    keep();
}

std::vector<Measurement> measure_series(const StudyPlan& plan, const Reference& reference,
                                        const StudyProgress& progress) {
    SeriesState state;
    go_on_with_series(
        plan, reference, state, [] {}, progress);
    return std::move(state.runs);
}

}  // namespace steplab
