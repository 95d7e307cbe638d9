#include "lab/speed_error.hpp"

#include "core/error.hpp"
#include "lab/gain_watch.hpp"
#include "lab/linearised.hpp"
#include "sim/catalogue.hpp"

#include <algorithm>
#include <cmath>
#include <variant>

namespace steplab {

namespace {

/// Runs shorter than this are repeated within a round until they have taken as long together, or so many times.
constexpr double least_seconds = 2e-4;
constexpr int most_repeats = 50;

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
        : plan_(plan), reference_(reference), out_(out), frequency_(frequency(plan)) {}

    /// False if only time ended it.
    bool over_dt(const std::string& method, Precision precision) {
        GainWatch gain;
        CostWatch cost(plan_.most_seconds_a_run);
        for (double wanted = static_cast<double>(fewest_steps(plan_, method, frequency_)); wanted < 1e9;
             wanted *= plan_.ratio) {
            const auto steps = static_cast<std::uint64_t>(std::ceil(wanted));
            if (cost.too_long(steps)) return false;
            const RunDescription run = run_over(plan_, method, precision, steps);
            cost.ran(steps, stepping_seconds(run, steps));
            out_.push_back(measure(run, steps, reference_));
            if (gain.gains_no_more(out_.back())) return true;
        }
        return true;
    }

    /// False if only time ended it.
    bool over_tolerance(const std::string& method, Precision precision) {
        GainWatch gain;
        const double least = precision == Precision::float_ ? 1e-8 : 1e-16;
        for (double tolerance = 1e-2; tolerance > least; tolerance /= 10) {
            RunDescription run = run_over(plan_, method, precision, 1);
            run.method_parameters.set("tolerance", tolerance);
            if (stepping_seconds(run, 1) > plan_.most_seconds_a_run) return false;
            out_.push_back(measure(run, 1, reference_));
            if (gain.gains_no_more(out_.back())) return true;
        }
        return true;
    }

private:
    const StudyPlan& plan_;
    const Reference& reference_;
    std::vector<Measurement>& out_;
    double frequency_;
};

double time_once(const Measurement& run) {
    double least = infinity, sum = 0;
    for (int repeat = 0; repeat < most_repeats && sum < least_seconds; ++repeat) {
        const double seconds = stepping_seconds(run.run, run.steps);
        least = std::min(least, seconds);
        sum += seconds;
    }
    return least;
}

}  // namespace

namespace {

/// From so many on an evaluation of a particle is dear.
constexpr double dear_partners = 140;

/// Particles that each one acts on, about: what an evaluation of it costs.
double partners(const RunDescription& scene) {
    const Model& entry = model(scene.model);
    const bool all_pairs = std::holds_alternative<PairForces>(entry.scene(scene.scene).forces);
    return all_pairs ? entry.particles(scene.scene) : 8;
}

}  // namespace

Reference reference_for(const StudyPlan& plan, double error, const std::function<void(int, double)>& progress) {
    RunDescription scene = plan.scene;
    scene.precision = Precision::double_;
    ReferenceEffort effort;
    effort.error = std::max(effort.error, error);
    effort.progress = progress;
    effort.most_particle_evaluations *= (error > 0 ? 0.2 : 1) * std::min(1.0, dear_partners / partners(scene));
    return reference(scene, std::vector{plan.time}, effort);
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

double frequency(const StudyPlan& plan) {
    const Model& scene = model(plan.scene.model);
    const LinearisedScene linearised(scene.scene(plan.scene.scene), scene.shape(plan.scene.scene));
    const double omega = highest_frequency(modes(linearised));
    return omega > 0 ? omega : 5 * 3.14159265358979 / plan.time;
}

std::uint64_t fewest_steps(const StudyPlan& plan, const std::string& method, double frequency) {
    const RunDescription run = run_over(plan, method, Precision::double_, 1);
    const double limit = linear_limit(steplab::method(method).info, run.method_parameters);
    const double phase = limit == 0 ? 0.5 : std::min(0.95 * limit, 20.0);
    return static_cast<std::uint64_t>(std::max(1.0, std::ceil(plan.time * frequency / phase)));
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
        bool complete = !takes_dt(id) || series.over_dt(id, precision);
        complete = (!takes_tolerance(id) || series.over_tolerance(id, precision)) && complete;
        if (!complete) state.cut.push_back({id, precision});
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
