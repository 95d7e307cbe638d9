#include "lab/advice.hpp"

#include "core/error.hpp"
#include "io/interruption.hpp"
#include "lab/answers.hpp"
#include "lab/gain_watch.hpp"
#include "lab/lyapunov.hpp"
#include "lab/readable_number.hpp"
#include "sim/catalogue.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <optional>
#include <string_view>

namespace steplab {

namespace {

/// Neighbouring dt differ by less than this at the end of a search.
constexpr double fine_ratio = 1.03;
/// A search is given up when it costs so many times the evaluations of the best run found so far.
constexpr double hopeless = 8;
/// If no short run keeps the error, runs may take so many times as long.
constexpr double long_run = 8;

/// The method everyone knows: looked for however dear it is, to compare with.
constexpr std::string_view classic = "rk4";

/// A run that was not worth its end.
struct Abandoned {};

class Search {
public:
    /// No run may take longer than `most_seconds`.
    Search(const StudyPlan& plan, double error, const Reference& reference, double frequency, double most_seconds)
        : plan_(plan), error_(error), reference_(reference), most_seconds_(most_seconds), frequency_(frequency) {}

    /// The cheapest runs found that keep the error: by dt, by tolerance.
    std::vector<Measurement> cheapest(const std::string& method, Precision precision) {
        std::vector<Measurement> found;
        if (takes_tolerance(method)) add(found, [&] { return over_tolerance(method, precision); });
        if (takes_dt(method)) add(found, [&] { return over_dt(method, precision); });
        return found;
    }

    double least_error() const { return least_error_; }
    const std::string& most_accurate() const { return most_accurate_; }
    /// A search ended because of what it cost: a longer one may find more.
    bool abandoned() const { return abandoned_; }

private:
    template <class Find>
    void add(std::vector<Measurement>& found, const Find& find) {
        std::optional<Measurement> run;
        try {
            run = find();
        } catch (const Abandoned&) {
            abandoned_ = true;
        }
        if (!run) return;
        least_evaluations_ = std::min(least_evaluations_, static_cast<double>(run->evaluations));
        least_seconds_ = std::min(least_seconds_, *run->wall_seconds);
        found.push_back(std::move(*run));
    }

    Measurement measured(const RunDescription& run, std::uint64_t steps) {
        const auto begin = std::chrono::steady_clock::now();
        const auto elapsed = [&] {
            return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
        };
        const double most = method_is_classic(run) ? most_seconds_ : std::min(most_seconds_, patience());
        Measurement result = measure(run, steps, reference_, [&] {
            check_interruption();
            if (elapsed() > most) throw Abandoned();
        });
        result.wall_seconds = elapsed();
        if (!result.diverged && result.error < least_error_) {
            least_error_ = result.error;
            most_accurate_ = result.run.method;
        }
        return result;
    }

    bool kept(const Measurement& run) const { return !run.diverged && run.error <= error_; }

    static bool method_is_classic(const RunDescription& run) { return run.method == classic; }

    /// How long a run may take beside the fastest found, of which short ones are measured badly.
    double patience() const { return hopeless * least_seconds_ + 0.02; }

    /// By evaluations and by the clock, as an evaluation of one method may be cheaper than another's.
    bool too_costly(const Measurement& run) {
        if (*run.wall_seconds > most_seconds_) throw Abandoned();
        return !method_is_classic(run.run) && static_cast<double>(run.evaluations) > hopeless * least_evaluations_ &&
               *run.wall_seconds > hopeless * least_seconds_;
    }

    /// Halves dt until the error is kept, then closes in on the largest dt that keeps it.
    std::optional<Measurement> over_dt(const std::string& method, Precision precision) {
        const auto at = [&](std::uint64_t steps) { return measured(run_over(plan_, method, precision, steps), steps); };
        std::uint64_t failed = 0;
        Measurement run = at(fewest_steps(plan_, method, frequency_));
        for (GainWatch gain; !kept(run);) {
            if (too_costly(run) || (gain.gains_no_more(run) && run.error < 1e-3 * plan_.time)) return std::nullopt;
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
            if (kept(tried)) {
                run = std::move(tried);
            } else {
                failed = middle;
            }
        }
    }

    /// From a loose tolerance down, 5, 2 and 1 in each decade, until the error is kept.
    std::optional<Measurement> over_tolerance(const std::string& method, Precision precision) {
        const int least = precision == Precision::float_ ? -8 : -17;
        const int first = std::min(-2, static_cast<int>(std::ceil(std::log10(error_))) + 1);
        GainWatch gain;
        for (int decade = first; decade >= least; --decade) {
            for (const char* digit : {"5", "2", "1"}) {
                RunDescription run = run_over(plan_, method, precision, 1);
                set_parameter(run, "tolerance", fmt::format("{}e{}", digit, decade));
                Measurement result = measured(run, 1);
                if (kept(result)) return result;
                if (too_costly(result) || gain.gains_no_more(result)) return std::nullopt;
            }
        }
        return std::nullopt;
    }

    const StudyPlan& plan_;
    double error_;
    const Reference& reference_;
    double least_evaluations_ = infinity, least_seconds_ = infinity;
    double least_error_ = infinity;
    std::string most_accurate_;
    double most_seconds_, frequency_;
    bool abandoned_ = false;
};

/// A cheap run found early tells sooner which searches are hopeless.
std::vector<std::string> most_accurate_first(std::vector<std::string> methods) {
    std::stable_sort(methods.begin(), methods.end(), [](const std::string& a, const std::string& b) {
        return method(a).info.order > method(b).info.order;
    });
    return methods;
}

std::vector<Measurement> candidates(const StudyPlan& plan, Search& search, const StudyProgress& progress) {
    std::vector<Measurement> found;
    const double all = static_cast<double>(plan.methods.size() * plan.precisions.size());
    double done = 0;
    for (const std::string& method : most_accurate_first(possible_methods(plan))) {
        for (const Precision precision : plan.precisions) {
            for (Measurement& run : search.cheapest(method, precision)) found.push_back(std::move(run));
            progress(++done / all * 0.8);
        }
    }
    return found;
}

/// Runs that keep the error, looked for first among short ones. Throws UsageError if there are none.
std::vector<Measurement> found_runs(const StudyPlan& plan, double error, const Reference& reference,
                                    const StudyProgress& progress) {
    const double fastest_motion = frequency(plan);
    for (const bool long_runs : {false, true}) {
        Search search(plan, error, reference, fastest_motion, plan.most_seconds_a_run * (long_runs ? long_run : 1));
        std::vector<Measurement> runs = candidates(plan, search, progress);
        if (!runs.empty()) return runs;
        if (search.abandoned() && !long_runs) continue;
        throw UsageError(fmt::format("no method was found to keep an error of {} here: the least was {}, by {}",
                                     typed(error), typed(search.least_error()), search.most_accurate()));
    }
    return {};
}

/// The fastest of the runs, made once more as its command line says, and the best run of every other method.
Advice verified(std::vector<Measurement> runs, double error, const Reference& reference) {
    Advice advice{runs.front(), {}};
    const auto seconds = advice.best.wall_seconds;
    advice.best = measure(advice.best.run, advice.best.steps, reference);
    advice.best.wall_seconds = seconds;
    if (advice.best.diverged || advice.best.error > error)
        throw Error(ExitCode::replay, "a run gave another error the second time");
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
        const std::string chaos = chaos_note(plan.scene, plan.time, infinity);  // whatever is left
        throw UsageError(
            fmt::format("an error of {} cannot be told here: what runs are judged by ({}) is itself known to {}; "
                        "take a larger error or a shorter time{}",
                        typed(error), reference.how, typed(certain), chaos.empty() ? "" : ". " + chaos));
    }
    std::vector<Measurement> runs = found_runs(plan, error, reference, progress);
    for (Measurement& run : runs) run.wall_seconds.reset();  // looks were within the clock
    time_interleaved(runs, plan.rounds, [&](double part) { progress(0.8 + 0.2 * part); });
    std::sort(runs.begin(), runs.end(), [](const Measurement& a, const Measurement& b) {
        return a.wall_seconds.value_or(infinity) < b.wall_seconds.value_or(infinity);
    });
    return verified(std::move(runs), error, reference);
}

}  // namespace steplab
