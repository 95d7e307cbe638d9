#include "lab/advice.hpp"

#include "core/error.hpp"
#include "core/text.hpp"
#include "lab/answers.hpp"
#include "lab/lyapunov.hpp"
#include "sim/catalogue.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <optional>

namespace steplab {

namespace {

/// Neighbouring dt differ by less than this at the end of a search.
constexpr double fine_ratio = 1.03;
/// A search is given up when it costs so many times the evaluations of the best run found so far.
constexpr double hopeless = 8;

class Search {
public:
    Search(const StudyPlan& plan, double error, const Reference& reference)
        : plan_(plan), error_(error), reference_(reference) {}

    /// The cheapest run found that keeps the error.
    std::optional<Measurement> cheapest(const std::string& method, Precision precision) {
        auto found =
            steplab::method(method).info.adaptive ? over_tolerance(method, precision) : over_dt(method, precision);
        if (found) least_evaluations_ = std::min(least_evaluations_, static_cast<double>(found->evaluations));
        return found;
    }

    double least_error() const { return least_error_; }
    const std::string& most_accurate() const { return most_accurate_; }

private:
    Measurement measured(const RunDescription& run, std::uint64_t steps) {
        const auto begin = std::chrono::steady_clock::now();
        Measurement result = measure(run, steps, reference_);
        result.wall_seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
        if (!result.diverged && result.error < least_error_) {
            least_error_ = result.error;
            most_accurate_ = result.run.method;
        }
        return result;
    }

    bool kept(const Measurement& run) const { return !run.diverged && run.error <= error_; }

    bool too_costly(const Measurement& run) const {
        return static_cast<double>(run.evaluations) > hopeless * least_evaluations_ ||
               run.wall_seconds.value_or(0) > plan_.most_seconds_a_run;
    }

    /// Halves dt until the error is kept, then closes in on the largest dt that keeps it.
    std::optional<Measurement> over_dt(const std::string& method, Precision precision) {
        const auto at = [&](std::uint64_t steps) { return measured(run_over(plan_, method, precision, steps), steps); };
        std::uint64_t failed = 0;
        Measurement run = at(fewest_steps(plan_, method));
        for (double best = infinity; !kept(run);) {
            if (too_costly(run) || (!run.diverged && run.error > 0.9 * best && run.error < 1e-3 * plan_.time))
                return std::nullopt;
            best = run.diverged ? best : std::min(best, run.error);
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

    /// From a loose tolerance down in steps of a factor 2 until the error is kept.
    std::optional<Measurement> over_tolerance(const std::string& method, Precision precision) {
        const double least = precision == Precision::float_ ? 1e-8 : 1e-17;
        for (double tolerance = std::min(0.1, 100 * error_); tolerance > least; tolerance /= 2) {
            RunDescription run = run_over(plan_, method, precision, 1);
            run.method_parameters.set("tolerance", tolerance);
            Measurement result = measured(run, 1);
            if (kept(result)) return result;
            if (too_costly(result)) return std::nullopt;
        }
        return std::nullopt;
    }

    const StudyPlan& plan_;
    double error_;
    const Reference& reference_;
    double least_evaluations_ = infinity;
    double least_error_ = infinity;
    std::string most_accurate_;
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
            if (auto run = search.cheapest(method, precision)) found.push_back(std::move(*run));
            progress(++done / all * 0.8);
        }
    }
    return found;
}

}  // namespace

Advice advise(const StudyPlan& plan, double error, const Reference& reference, const StudyProgress& progress) {
    const double certain = reference.moments.back().error;
    if (error < certain) {
        const std::string chaos = chaos_note(plan.scene, reference);
        throw UsageError(
            fmt::format("an error of {} cannot be told here: the reference ({}) is itself known to {:.1e}{}",
                        number_text(error), reference.how, certain, chaos.empty() ? "" : ". " + chaos));
    }
    Search search(plan, error, reference);
    std::vector<Measurement> runs = candidates(plan, search, progress);
    if (runs.empty()) {
        throw UsageError(fmt::format("no method keeps an error of {} here: the least was {:.1e}, by {}",
                                     number_text(error), search.least_error(), search.most_accurate()));
    }
    for (Measurement& run : runs) run.wall_seconds.reset();  // looks were within the clock
    time_interleaved(runs, plan.rounds, [&](double part) { progress(0.8 + 0.2 * part); });
    std::sort(runs.begin(), runs.end(), [](const Measurement& a, const Measurement& b) {
        return a.wall_seconds.value_or(infinity) < b.wall_seconds.value_or(infinity);
    });
    Advice advice{runs.front(), {}};
    const auto seconds = advice.best.wall_seconds;
    advice.best = measure(advice.best.run, advice.best.steps, reference);
    advice.best.wall_seconds = seconds;
    for (Measurement& run : runs) {
        const bool known = run.run.method == advice.best.run.method ||
                           std::any_of(advice.others.begin(), advice.others.end(),
                                       [&](const Measurement& other) { return other.run.method == run.run.method; });
        if (!known) advice.others.push_back(std::move(run));
    }
    return advice;
}

}  // namespace steplab
