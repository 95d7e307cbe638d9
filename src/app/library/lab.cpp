#include "app/library/implementation.hpp"
#include "core/error.hpp"
#include "core/interruption.hpp"
#include "lab/limits/all_limits.hpp"
#include "lab/study/advice.hpp"
#include "lab/study/answers.hpp"
#include "lab/study/study.hpp"
#include "session/comparison.hpp"
#include "sim/catalogue.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <steplab/lab.hpp>

namespace steplab::library {

namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();
constexpr std::uint64_t most_samples = 1'000'000'000'000;
constexpr double bytes_of_sample = 6 * sizeof(double) + sizeof(std::uint64_t);

void check_positive(double value, std::string_view name) {
    if (!(value > 0) || std::isinf(value)) throw steplab::UsageError(fmt::format("{} must be finite and > 0", name));
}

/// For the searches of the lab, which call it while they go on.
void watch(double) { check_interruption(); }

StudyPlan plan_of(const Scene& scene, double until, const Studied& studied) {
    check_positive(until, "until");
    StudyPlan plan = plan_for(run_of(scene), until, studied.quick);
    if (!studied.methods.empty()) plan.methods = studied.methods;
    for (const std::string& id : plan.methods) method(id);  // throws of one that is not known
    if (!studied.precisions.empty()) plan.precisions.clear();
    for (const std::string& name : studied.precisions) plan.precisions.push_back(precision_named(name, plan.scene));
    return plan;
}

Measurement measurement_of(const steplab::Measurement& from) {
    return {.method = from.run.method,
            .precision = std::string(id(from.run.precision)),
            .dt = from.run.dt,
            .parameters = parameters_of(from.run.method_parameters),
            .steps = from.steps,
            .evaluations = from.result.evaluations,
            .error = from.diverged() ? none : from.error,
            .energy_error = from.diverged() ? none : from.result.energy_error,
            .wall_seconds = from.wall_seconds,
            .status = from.result.status(),
            .hash = from.result.hash};
}

std::vector<Measurement> measurements_of(const std::vector<steplab::Measurement>& runs) {
    std::vector<Measurement> all;
    all.reserve(runs.size());
    for (const steplab::Measurement& run : runs) all.push_back(measurement_of(run));
    return all;
}

/// Of runs whose dt is halved until rounding, or the reference's error, is near.
std::optional<double> order_of_series(const StudyPlan& plan, const std::string& method, const Reference& reference) {
    constexpr int halvings = 8;
    const double floor = 100 * std::max(1e-14, reference.moments.back().error);
    std::optional<double> order, coarse;
    std::uint64_t steps = 2 * fewest_steps(plan, method, frequency(plan));
    for (int i = 0; i < halvings; ++i, steps *= 2) {
        const auto run =
            measure(run_over(plan, method, Precision::double_, steps), steps, reference, check_interruption);
        if (run.diverged()) continue;
        if (run.error < floor) break;
        if (coarse) order = std::log2(*coarse / run.error);
        coarse = run.error;
    }
    return order;
}

void add(Comparison& to, double time, const Compared& at) {
    to.times.push_back(time);
    to.error.push_back(at.error);
    to.rms_error.push_back(at.rms_error);
    to.energy_error.push_back(at.energy_error.value_or(none));
    to.momentum_error.push_back(at.momentum_error.value_or(none));
    to.reference_error.push_back(at.reference_error);
    to.evaluations.push_back(at.evaluations);
}

}  // namespace

std::vector<Limit> limits(const Scene& scene, const std::vector<std::string>& methods, const std::string& precision) {
    return translated([&] {
        RunDescription base = run_of(scene);
        base.precision = precision_named(precision, base);
        check(base);
        std::vector<RunDescription> runs;
        runs.reserve(methods.size());
        for (const std::string& id : methods) runs.push_back(with_method(base, id));
        if (methods.empty()) {
            for (const Method& each : steplab::methods()) runs.push_back(with_method(base, each.info.id));
        }
        const StabilityLab lab(base);
        std::vector<Limit> found;
        for (const steplab::Limit& each : all_limits(lab, runs, [](std::size_t) { check_interruption(); }))
            found.push_back({.method = each.description.method,
                             .precision = std::string(id(each.description.precision)),
                             .omega_max = each.omega_max,
                             .theory = each.theory,
                             .measured = each.measured,
                             .note = each.note});
        return found;
    });
}

std::vector<Comparison> compare(const Scene& scene, const std::vector<Settings>& runs, double until,
                                std::uint64_t samples) {
    return translated([&] {
        check_positive(until, "until");
        if (runs.empty() || runs.size() > RunComparison::most_runs)
            throw steplab::UsageError(
                fmt::format("one to {} runs are compared (got {})", RunComparison::most_runs, runs.size()));
        if (samples == 0 || samples > most_samples)
            throw steplab::UsageError(fmt::format("samples must be from 1 to {} (got {})", most_samples, samples));
        check_memory(static_cast<double>(samples) * static_cast<double>(runs.size()) * bytes_of_sample,
                     fmt::format("{} samples of {} runs", samples, runs.size()), "take fewer samples");
        std::vector<RunDescription> descriptions;
        std::vector<Comparison> all;
        for (const Settings& settings : runs) {
            const RunDescription run = described(scene, settings);
            all.push_back({.method = run.method, .precision = std::string(id(run.precision)), .dt = run.dt});
            descriptions.push_back(run);
        }
        RunComparison comparison(descriptions, until, samples);
        for (std::uint64_t sample = 0; sample <= samples; ++sample) {
            check_interruption();
            const auto now = comparison.at(sample);
            for (std::size_t i = 0; i < all.size(); ++i) {
                if (now[i]) add(all[i], comparison.time(sample), *now[i]);
            }
        }
        for (std::size_t i = 0; i < all.size(); ++i) {
            all[i].reference = comparison.reference(i);
            if (const auto& divergence = comparison.run(i).divergence()) all[i].reason = divergence->message;
        }
        return all;
    });
}

std::vector<Measurement> report(const Scene& scene, double until, const Studied& studied) {
    return translated([&] {
        const StudyPlan plan = plan_of(scene, until, studied);
        const Reference reference = reference_for(plan, 0, [](int, double) { check_interruption(); });
        return measurements_of(measure_series(plan, reference, watch));
    });
}

Advice advise(const Scene& scene, double error, double until, const Studied& studied) {
    return translated([&] {
        check_positive(error, "error");
        const StudyPlan plan = plan_of(scene, until, studied);
        const Reference reference =
            reference_for(plan, error / finer_reference, [](int, double) { check_interruption(); });
        const steplab::Advice advice = steplab::advise(plan, error, reference, watch);
        return Advice{.best = measurement_of(advice.best),
                      .others = measurements_of(advice.others),
                      .command = fmt::format("{} --steps {}", command_line(advice.best.run), advice.best.steps),
                      .reference = reference.how};
    });
}

std::optional<double> order(const Scene& scene, const std::string& method, double until) {
    return translated([&] {
        const StudyPlan plan = plan_of(scene, until, {.methods = {method}, .precisions = {"double"}});
        const RunDescription usual = with_method(plan.scene, method);
        if (chooses_its_steps(usual))
            throw steplab::UsageError(fmt::format("{} chooses its own steps: its errors do not follow dt", method));
        const Reference reference = reference_for(plan, 0, [](int, double) { check_interruption(); });
        return order_of_series(plan, method, reference);
    });
}

}  // namespace steplab::library
