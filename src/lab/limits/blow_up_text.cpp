#include "core/number_text.hpp"
#include "lab/limits/blow_up.hpp"
#include "sim/catalogue.hpp"
#include "sim/run/linear_limit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <vector>

namespace steplab {

namespace {

/// Of the kinetic energy of an oscillation: who has this much is named.
constexpr double most_of_it = 0.9;
constexpr std::size_t most_named = 3;

/// "Up to step 37 (t = 3.7 s) the energy was at most 1 % too high; its error then grew by a factor of 1.9 with each
/// step."
std::string since_when(const BlowUp& blow_up) {
    const Divergence& divergence = blow_up.divergence;
    const std::string good = fmt::format("Up to step {} (t = {} s) the energy was at most 1 % too high", blow_up.step,
                                         reading_text(blow_up.time));
    if (blow_up.growth)
        return fmt::format("{}; its error then grew by a factor of {} with each step.", good,
                           significant(*blow_up.growth, 3));
    const std::uint64_t later = divergence.step - std::min(divergence.step, blow_up.step);
    return fmt::format("{}; {} later it was impossible.", good,
                       later > 1 ? fmt::format("{} steps", later) : "one step");
}

/// The particles that have most of it, those with the largest share first.
std::vector<std::size_t> carriers(const std::vector<double>& weights) {
    std::vector<std::size_t> order(weights.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) { return weights[i] > weights[j]; });
    double sum = 0;
    std::size_t count = 0;
    while (count < order.size() && sum < most_of_it) sum += weights[order[count++]];
    order.resize(count);
    return order;
}

/// "particles 3 and 17", "27 of 100 particles"
std::string carriers_text(const std::vector<double>& weights) {
    std::vector<std::size_t> named = carriers(weights);
    if (named.size() > most_named) return fmt::format("{} of the {} particles", named.size(), weights.size());
    std::sort(named.begin(), named.end());
    std::string text = named.size() == 1 ? "particle " : "particles ";
    for (std::size_t i = 0; i < named.size(); ++i)
        text += fmt::format("{}{}", i == 0 ? "" : i + 1 == named.size() ? " and " : ", ", named[i]);
    return text;
}

std::string oscillation_text(const PresentLimit& limit) {
    std::string text =
        fmt::format("the scene's fastest oscillation (ω = {} rad/s", reading_text(limit.oscillation.omega));
    if (!limit.oscillation.weights.empty()) text += ", of " + carriers_text(limit.oscillation.weights);
    return text + ")";
}

/// "1.12 times the stability limit 1.434 s of rk4"
std::string times_the_limit(const RunDescription& run, double limit) {
    return fmt::format("{} times the stability limit {} s of {}", significant(std::abs(run.dt) / limit, 3),
                       reading_text(limit), run.method);
}

/// How a step treats that oscillation.
std::string growth_text(const RunDescription& run, const PresentLimit& limit) {
    const Method& entry = method(run.method);
    const double growth =
        step_growth(entry, run.method_parameters, limit.oscillation.omega, facts_of(run).drag, std::abs(run.dt));
    if (!(growth > 1) || !std::isfinite(growth)) return "each step makes its amplitude larger";
    return fmt::format("each step multiplies its amplitude by {}", significant(growth, 3));
}

std::string beyond_from_the_start(const RunDescription& run, const PresentLimit& limit) {
    return fmt::format("dt = {} s is {} for {}: {}, however small it was at first.", significant(run.dt, 4),
                       times_the_limit(run, *limit.limit), oscillation_text(limit), growth_text(run, limit));
}

/// "0.8", "less than 0.01": dt as part of a limit.
std::string part_text(double part) { return part < 0.01 ? "less than 0.01" : significant(part, 2); }

std::string stiffened(const RunDescription& run, const PresentLimit& start, const PresentLimit& then) {
    return fmt::format(
        "At the start dt = {} s was {} of the limit. The scene stiffened as it moved: at t = {} s its fastest "
        "oscillation "
        "had ω = {} instead of {} rad/s ({}), and dt was {} there: {}.",
        significant(run.dt, 4), part_text(std::abs(run.dt) / *start.limit), reading_text(then.time),
        reading_text(then.oscillation.omega), reading_text(start.oscillation.omega),
        carriers_text(then.oscillation.weights), times_the_limit(run, *then.limit), growth_text(run, then));
}

std::string too_coarse(const RunDescription& run, const PresentLimit& limit) {
    if (!limit.limit || std::isinf(*limit.limit))
        return fmt::format(
            "No oscillation is unstable at dt = {} s; the steps are too long for the forces, which change within one.",
            significant(run.dt, 4));
    return fmt::format(
        "dt = {} s stayed below the stability limit of every oscillation (at most {} of it): no oscillation is "
        "unstable, "
        "but the motion is so violent that the forces change completely within one step.",
        significant(run.dt, 4), part_text(std::abs(run.dt) / *limit.limit));
}

std::string cause(const BlowUp& blow_up) {
    const PresentLimit &start = blow_up.start, &then = blow_up.limit;
    const RunDescription& run = blow_up.run;
    if (method(run.method).info.curiosity)
        return fmt::format("{} repeats a mistake of 2008, which makes it fail at any dt.", run.method);
    if (!then.limit) return "The method chooses its own steps; its numbers left what the precision holds.";
    if (*then.limit == 0)
        return fmt::format("{} makes every oscillation larger at any dt. Of {}, {} at this dt.", run.method,
                           oscillation_text(then), growth_text(run, then));
    const double dt = std::abs(run.dt);
    if (start.limit && dt > *start.limit) return beyond_from_the_start(run, start);
    if (dt > *then.limit) return start.limit ? stiffened(run, start, then) : beyond_from_the_start(run, then);
    return too_coarse(run, then);
}

/// That the oscillation named is the one that grew.
std::string evidence(const BlowUp& blow_up) {
    if (!(blow_up.share >= 0.01)) return {};
    return fmt::format(" At the end it held {} % of the kinetic energy.", rounded_text(100 * blow_up.share));
}

}  // namespace

std::string explanation_of(const BlowUp& blow_up) {
    if (blow_up.divergence.stop) return {};  // the message says all
    return since_when(blow_up) + " " + cause(blow_up) + evidence(blow_up);
}

}  // namespace steplab
