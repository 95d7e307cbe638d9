#include "lab/study/speed_error.hpp"

#include "core/error.hpp"
#include "core/interruption.hpp"
#include "lab/study/gain_watch.hpp"
#include "lab/study/parallel.hpp"
#include "lab/study/patience.hpp"
#include "sim/catalogue.hpp"
#include "sim/run/linearised.hpp"
#include "sim/run/memory.hpp"
#include "sim/run/starting.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <mutex>
#include <optional>
#include <utility>

namespace steplab {

namespace {

/// Runs shorter than this are repeated within a round until they have taken this long in total, up to a number of
/// times.
constexpr double least_seconds = 2e-4;
constexpr int most_repeats = 50;

/// Estimates the cost of the next run from the last one.
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
    Series(const StudyPlan& plan, const Reference& reference, double frequency, const std::string& method,
           Precision precision, const Execution& execution)
        : plan_(plan),
          reference_(reference),
          frequency_(frequency),
          method_(method),
          precision_(precision),
          execution_(execution) {}

    MeasuredSeries measured() {
        bool complete = !takes_dt(method_) || over_dt();
        complete = (!takes_tolerance(method_) || over_tolerance()) && complete;
        return {std::move(runs_), !complete};
    }

private:
    /// False if the series was ended only by time.
    bool over_dt() {
        GainWatch gain;
        CostWatch cost(plan_.most_seconds_a_run);
        const auto most = static_cast<double>(plan_.most_steps_a_run);
        for (double wanted = static_cast<double>(fewest_steps(plan_, method_, frequency_)); wanted < most;
             wanted *= plan_.ratio) {
            const auto steps = static_cast<std::uint64_t>(std::ceil(wanted));
            if (cost.too_long(steps)) return false;
            auto result = made(run_over(plan_, method_, precision_, steps), steps);
            if (!result) return false;
            runs_.push_back(std::move(*result));
            if (!runs_.back().diverged()) cost.ran(steps, runs_.back().rough_seconds);  // else it ended before
            if (gain.gains_no_more(runs_.back())) return true;
        }
        return true;
    }

    /// False if the series was ended only by time.
    bool over_tolerance() {
        GainWatch gain;
        const double least = precision_ == Precision::float_ ? 1e-8 : 1e-16;
        for (double tolerance = 1e-2; tolerance > least; tolerance /= 10) {
            RunDescription run = run_over(plan_, method_, precision_, 1);
            run.method_parameters.set("tolerance", tolerance);
            auto result = made(run, 1);
            if (!result || result->rough_seconds > plan_.most_seconds_a_run) return false;
            runs_.push_back(std::move(*result));
            if (gain.gains_no_more(runs_.back())) return true;
        }
        return true;
    }

    /// None if it takes too long.
    std::optional<Measurement> made(const RunDescription& run, std::uint64_t steps) const {
        constexpr double patience = 30;  // how long a first run takes is not known before
        try {
            const Patience until(patience * plan_.most_seconds_a_run);
            return measure(run, steps, reference_, check_interruption, execution_);
        } catch (const PatienceEnds&) {
            return std::nullopt;
        }
    }

    const StudyPlan& plan_;
    const Reference& reference_;
    double frequency_;
    std::string method_;
    Precision precision_;
    Execution execution_;
    std::vector<Measurement> runs_;
};

/// Series measured in parallel and collected in the order of the plan.
class SeriesInOrder {
public:
    SeriesInOrder(const StudyPlan& plan, SeriesState& state, const std::function<void()>& save)
        : plan_(plan), state_(state), save_(save), methods_(possible_methods(plan)) {}

    std::size_t all() const { return methods_.size() * plan_.precisions.size(); }

    /// `progress` is called with the number of series that are done.
    void measure(const Reference& reference, const std::function<void(std::size_t)>& progress) {
        std::vector<std::size_t> left;
        for (std::size_t place = state_.series; place < all(); ++place) {
            if (!state_.ahead.contains(place)) left.push_back(place);
        }
        if (left.empty()) return;
        const double fastest_motion = frequency(plan_);
        std::size_t done = all() - left.size();
        progress(done);
        parallel_for_each(left.size(), most_bytes(plan_), [&](std::size_t i, const Execution& execution) {
            const std::size_t place = left[i];
            Series series(plan_, reference, fastest_motion, method_of(place), precision_of(place), execution);
            MeasuredSeries measured = series.measured();
            const std::lock_guard lock(mutex_);
            state_.ahead.emplace(place, std::move(measured));
            gather();
            save_();
            progress(++done);
        });
    }

private:
    const std::string& method_of(std::size_t series) const { return methods_[series / plan_.precisions.size()]; }
    Precision precision_of(std::size_t series) const { return plan_.precisions[series % plan_.precisions.size()]; }

    /// Moves what is complete, up to the first incomplete series.
    void gather() {
        for (auto next = state_.ahead.begin(); next != state_.ahead.end() && next->first == state_.series;
             next = state_.ahead.erase(next), ++state_.series) {
            MeasuredSeries& series = next->second;
            std::move(series.runs.begin(), series.runs.end(), std::back_inserter(state_.runs));
            if (series.cut) state_.cut.push_back({method_of(state_.series), precision_of(state_.series)});
        }
    }

    const StudyPlan& plan_;
    SeriesState& state_;
    const std::function<void()>& save_;
    std::vector<std::string> methods_;
    std::mutex mutex_;  ///< of the state
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

/// With more partners than this an evaluation is expensive.
constexpr double expensive_partners = 140;

/// Approximate number of particles that each one interacts with: the cost of an evaluation per particle.
double partners(const RunDescription& scene) {
    return 2 * interacting_pairs(plan_of(scene)) / model_of(scene).particles(scene.scene);
}

}  // namespace

Reference reference_for(const StudyPlan& plan, double error, const std::function<void(int, double)>& progress) {
    RunDescription scene = plan.scene;
    scene.precision = Precision::double_;
    ReferenceEffort effort;
    effort.error = std::max(effort.error, error);
    effort.progress = progress;
    effort.least_gain = plan.least_reference_gain;
    effort.most_particle_evaluations *= plan.reference_effort;
    effort.most_particle_evaluations *= (error > 0 ? 0.2 : 1) * std::min(1.0, expensive_partners / partners(scene));
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
    const Model& scene = model_of(plan.scene);
    const LinearisedScene linearised(plan_of(plan.scene), scene.shape(plan.scene.scene));
    const double omega = highest_frequency(modes(linearised));
    check_stiffness(omega);
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

double most_bytes(const StudyPlan& plan) {
    double most = 0;
    for (const std::string& id : possible_methods(plan))
        most = std::max(most, bytes_of_run(run_over(plan, id, Precision::double_, 1)));
    return most;
}

void time_interleaved(std::vector<Measurement>& runs, int rounds, const StudyProgress& progress) {
    for (int round = 0; round < rounds; ++round) {
        for (std::size_t i = 0; i < runs.size(); ++i) {
            if (runs[i].diverged()) continue;
            runs[i].wall_seconds = std::min(runs[i].wall_seconds.value_or(infinity), time_once(runs[i]));
            progress((round + static_cast<double>(i) / static_cast<double>(runs.size())) / rounds);
        }
    }
}

void continue_series(const StudyPlan& plan, const Reference& reference, SeriesState& state,
                     const std::function<void()>& save, const StudyProgress& progress) {
    const double share = 1.0 / (1 + plan.rounds);  // each run is made once, then once per round
    SeriesInOrder series(plan, state, save);
    const auto all = static_cast<double>(series.all());
    series.measure(reference, [&](std::size_t done) { progress(share * static_cast<double>(done) / all); });
    if (!state.timed)
        time_interleaved(state.runs, plan.rounds, [&](double part) { progress(share + (1 - share) * part); });
    state.timed = true;
    save();
}

std::vector<Measurement> measure_series(const StudyPlan& plan, const Reference& reference,
                                        const StudyProgress& progress) {
    SeriesState state;
    continue_series(
        plan, reference, state, [] {}, progress);
    return std::move(state.runs);
}

}  // namespace steplab
