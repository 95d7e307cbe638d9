#include "lab/study/advice.hpp"

#include "core/error.hpp"
#include "core/interruption.hpp"
#include "core/number_text.hpp"
#include "core/watching.hpp"
#include "lab/study/answers.hpp"
#include "lab/study/gain_watch.hpp"
#include "lab/study/lyapunov.hpp"
#include "lab/study/parallel.hpp"
#include "sim/catalogue.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <iterator>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace steplab {

namespace {

/// At the end of a search, neighbouring dt differ by less than this factor.
constexpr double fine_ratio = 1.03;
/// A search is abandoned when it costs this many times the evaluations of the best run found so far.
constexpr double abandon_factor = 8;
/// If no short run keeps the error, runs may take this many times as long.
constexpr double long_run = 8;

/// The best-known method: always searched for, whatever its cost, for comparison.
constexpr std::string_view classic = "rk4";

/// Thrown to end a run that takes too long.
struct Abandoned {};

/// What the searches share with each other.
class Found {
public:
    void measured(const Measurement& run) {
        const std::lock_guard lock(mutex_);
        if (run.diverged() || run.error >= least_error_) return;
        least_error_ = run.error;
        most_accurate_ = run.run.method;
    }
    void reached(const Measurement& run) {
        const std::lock_guard lock(mutex_);
        evaluations_ = std::min(evaluations_, static_cast<double>(run.result.evaluations));
        seconds_ = std::min(seconds_, run.rough_seconds);
    }
    void abandoned() {
        const std::lock_guard lock(mutex_);
        any_abandoned_ = true;
    }

    /// Judged by evaluations and by time, because an evaluation of one method may be cheaper than that of another.
    bool is_too_costly(const Measurement& run) const {
        const std::lock_guard lock(mutex_);
        return static_cast<double>(run.result.evaluations) > abandon_factor * evaluations_ &&
               run.rough_seconds > abandon_factor * seconds_;
    }
    /// Longest time allowed for a run, relative to the fastest found; times of short runs are inaccurate.
    double longest_time() const {
        const std::lock_guard lock(mutex_);
        return abandon_factor * seconds_ + 0.02;
    }

    // After all searches have ended.
    double least_error() const { return least_error_; }
    const std::string& most_accurate() const { return most_accurate_; }
    /// True if a search ended because of its cost: a longer one may find more.
    bool any_abandoned() const { return any_abandoned_; }

private:
    mutable std::mutex mutex_;
    double evaluations_ = infinity, seconds_ = infinity;  ///< the smallest that kept the error
    double least_error_ = infinity;
    std::string most_accurate_;
    bool any_abandoned_ = false;
};

/// What all searches are to find.
struct Question {
    const StudyPlan& plan;
    double error;
    const Reference& reference;
    double frequency;
    double most_seconds;             ///< no run may take longer
    std::function<void()> progress;  ///< called in runs by any thread; may throw to end all
};

/// Finds the cheapest runs of one method in one precision that keep the error.
class Search {
public:
    Search(const Question& question, const std::string& method, Precision precision, const Execution& execution,
           Found& found)
        : question_(question), method_(method), precision_(precision), execution_(execution), found_(found) {}

    /// The cheapest run by dt, and by tolerance.
    std::vector<Measurement> cheapest() {
        std::vector<Measurement> runs;
        if (takes_tolerance(method_)) add(runs, [&] { return over_tolerance(); });
        if (takes_dt(method_)) add(runs, [&] { return over_dt(); });
        return runs;
    }

private:
    template <class Find>
    void add(std::vector<Measurement>& runs, const Find& find) {
        std::optional<Measurement> run;
        try {
            run = find();
        } catch (const Abandoned&) {
            found_.abandoned();
        }
        if (!run) return;
        found_.reached(*run);
        runs.push_back(std::move(*run));
    }

    Measurement measured(const RunDescription& run, std::uint64_t steps) {
        const auto begin = std::chrono::steady_clock::now();
        // Within a step, too: one of a method that chooses its own steps may be the whole run.
        const Watching watching([&] {
            question_.progress();
            const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - begin;
            const double longest =
                is_classic() ? infinity : found_.longest_time();  // other searches may find a cheap run meanwhile
            if (elapsed.count() > std::min(question_.most_seconds, longest)) throw Abandoned();
        });
        Measurement result = measure(run, steps, question_.reference, check_interruption, execution_);
        found_.measured(result);
        return result;
    }

    bool keeps_error(const Measurement& run) const { return !run.diverged() && run.error <= question_.error; }
    bool is_classic() const { return method_ == classic; }

    bool too_costly(const Measurement& run) {
        if (run.rough_seconds > question_.most_seconds) throw Abandoned();
        return !is_classic() && found_.is_too_costly(run);
    }

    /// Halves dt until the error is kept, then finds the largest dt that keeps it by bisection.
    std::optional<Measurement> over_dt() {
        const StudyPlan& plan = question_.plan;
        const auto at = [&](std::uint64_t steps) {
            return measured(run_over(plan, method_, precision_, steps), steps);
        };
        std::uint64_t failed = 0;
        Measurement run = at(fewest_steps(plan, method_, question_.frequency));
        for (GainWatch gain; !keeps_error(run);) {
            if (too_costly(run) || (gain.gains_no_more(run) && run.error < 1e-3 * plan.time)) return std::nullopt;
            failed = run.steps;
            run = at(2 * failed);
        }
        if (failed > 0) close_in(at, failed, run);
        return run;
    }

    template <class At>
    void close_in(const At& at, std::uint64_t failed, Measurement& run) {
        while (run.steps > failed + 1 && static_cast<double>(run.steps) > fine_ratio * static_cast<double>(failed)) {
            const double between = std::sqrt(static_cast<double>(failed) * static_cast<double>(run.steps));
            const std::uint64_t middle = std::clamp(static_cast<std::uint64_t>(between), failed + 1, run.steps - 1);
            Measurement tried = at(middle);
            if (keeps_error(tried)) {
                run = std::move(tried);
            } else {
                failed = middle;
            }
        }
    }

    /// Decreases the tolerance, 5, 2 and 1 in each decade, until the error is kept.
    std::optional<Measurement> over_tolerance() {
        const int least = precision_ == Precision::float_ ? -8 : -17;
        const int first = std::min(-2, static_cast<int>(std::ceil(std::log10(question_.error))) + 1);
        GainWatch gain;
        for (int decade = first; decade >= least; --decade) {
            for (const char* digit : {"5", "2", "1"}) {
                RunDescription run = run_over(question_.plan, method_, precision_, 1);
                set_parameter(run, "tolerance", fmt::format("{}e{}", digit, decade));
                Measurement result = measured(run, 1);
                if (keeps_error(result)) return result;
                if (too_costly(result) || gain.gains_no_more(result)) return std::nullopt;
            }
        }
        return std::nullopt;
    }

    const Question& question_;
    std::string method_;
    Precision precision_;
    Execution execution_;
    Found& found_;
};

/// A cheap run found early allows other searches to be abandoned sooner.
std::vector<std::string> most_accurate_first(std::vector<std::string> methods) {
    std::stable_sort(methods.begin(), methods.end(), [](const std::string& a, const std::string& b) {
        return method(a).info.order > method(b).info.order;
    });
    return methods;
}

/// The cheapest runs of all methods and precisions, searched for in parallel.
std::vector<Measurement> candidates(Question question, Found& found, const StudyProgress& progress) {
    const std::vector<std::string> methods = most_accurate_first(possible_methods(question.plan));
    const std::vector<Precision>& precisions = question.plan.precisions;
    std::vector<std::vector<Measurement>> runs(methods.size() * precisions.size());
    std::mutex mutex;
    std::size_t done = 0;
    const auto report = [&] { progress(0.8 * static_cast<double>(done) / static_cast<double>(runs.size())); };
    question.progress = [&] {
        const std::lock_guard lock(mutex);
        report();
    };
    parallel_for_each(runs.size(), most_bytes(question.plan), [&](std::size_t i, const Execution& execution) {
        const std::string& method = methods[i / precisions.size()];
        runs[i] = Search(question, method, precisions[i % precisions.size()], execution, found).cheapest();
        const std::lock_guard lock(mutex);
        ++done;
        report();
    });
    std::vector<Measurement> all;
    for (auto& some : runs) std::move(some.begin(), some.end(), std::back_inserter(all));
    return all;
}

double watched_frequency(const StudyPlan& plan, const StudyProgress& progress) {
    const Watching watching([&] { progress(0); });
    return frequency(plan);
}

/// Runs that keep the error; short runs are tried first. Throws UsageError if there are none.
std::vector<Measurement> found_runs(const StudyPlan& plan, double error, const Reference& reference,
                                    const StudyProgress& progress) {
    const double fastest_motion = watched_frequency(plan, progress);
    for (const bool long_runs : {false, true}) {
        Found found;
        const double most_seconds = plan.most_seconds_a_run * (long_runs ? long_run : 1);
        std::vector<Measurement> runs =
            candidates({plan, error, reference, fastest_motion, most_seconds, {}}, found, progress);
        if (!runs.empty()) return runs;
        if (found.any_abandoned() && !long_runs) continue;
        throw UsageError(fmt::format("no method reached an error of {} here: the smallest was {}, by {}", typed(error),
                                     typed(found.least_error()), found.most_accurate()));
    }
    return {};
}

/// The fastest of the runs, repeated as its command line says, and the best run of every other method.
Advice verified(std::vector<Measurement> runs, double error, const Reference& reference) {
    Advice advice{runs.front(), {}};
    const auto seconds = advice.best.wall_seconds;
    advice.best = measure(advice.best.run, advice.best.steps, reference);
    advice.best.wall_seconds = seconds;
    if (advice.best.diverged() || advice.best.error > error)
        throw Error(ExitCode::replay, "a run gave a different error when it was repeated");
    for (Measurement& run : runs) {
        const bool known = run.run.method == advice.best.run.method ||
                           std::any_of(advice.others.begin(), advice.others.end(),
                                       [&](const Measurement& other) { return other.run.method == run.run.method; });
        if (!known) advice.others.push_back(std::move(run));
    }
    return advice;
}

}  // namespace

Advice advise(const StudyPlan& plan, double error, const Reference& reference, const StudyProgress& progress) {
    const double certain = reference.moments.back().error;
    if (error < certain) {
        const std::string chaos = chaos_note(plan.scene, plan.time, infinity);  // at any error of the reference
        throw UsageError(
            fmt::format("an error of {} cannot be verified here: the reference solution ({}) is itself accurate to {} "
                        "only; choose a larger error or a shorter time{}",
                        typed(error), reference.how, typed(certain), chaos.empty() ? "" : ". " + chaos));
    }
    std::vector<Measurement> runs = found_runs(plan, error, reference, progress);
    time_interleaved(runs, plan.rounds, [&](double part) { progress(0.8 + 0.2 * part); });
    std::sort(runs.begin(), runs.end(), [](const Measurement& a, const Measurement& b) {
        return a.wall_seconds.value_or(infinity) < b.wall_seconds.value_or(infinity);
    });
    return verified(std::move(runs), error, reference);
}

}  // namespace steplab
