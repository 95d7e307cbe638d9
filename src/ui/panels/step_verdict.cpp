#include "ui/panels/step_verdict.hpp"

#include "core/number_text.hpp"

#include <fmt/format.h>

#include <cmath>

namespace steplab::ui {
namespace {

/// Closer to the limit, a small change of the scene passes it.
constexpr double near_limit = 0.9;

std::string share_text(double share) {
    if (share < 0.01) return "< 0.01";
    return share < 10 ? fmt::format("{:.2f}", share) : rounded_text(share);
}

/// "0.97 of the limit 0.102 s"
std::string of_limit(double dt, double limit) {
    return fmt::format("{} of the limit {} s", share_text(dt / limit), reading_text(limit));
}

std::string steps_text(double steps) {
    const std::string number = rounded_text(steps);
    return fmt::format("{} {} per period", number, number == "1" ? "step" : "steps");
}

std::string tooltip_of(const StabilityLimit& known, const std::optional<Resolution>& resolution) {
    std::string text =
        fmt::format("from linear theory for the scene at rest\nlargest angular frequency ω_max = {} rad/s",
                    reading_text(known.omega_max));
    if (!resolution) return text;
    text += fmt::format("\n{} of that oscillation", steps_text(resolution->steps_per_period));
    if (resolution->error < 1)
        text +=
            fmt::format("; in each, its amplitude is multiplied by {}, and its error grows by {} % of the amplitude",
                        setting_text(resolution->amplification, 3), rounded_text(100 * resolution->error));
    return text;
}

StepVerdict below_limit(double dt, double limit, const std::optional<Resolution>& resolution) {
    if (resolution && !resolution->is_good())
        return {Lamp::caution, "stable, but only " + steps_text(resolution->steps_per_period), {}};
    if (std::isinf(limit)) return {Lamp::good, "stable at any dt", {}};
    const bool close = dt > near_limit * limit;
    return {
        close ? Lamp::caution : Lamp::good, (close ? "stable, but only just: " : "stable: ") + of_limit(dt, limit), {}};
}

StepVerdict against_limit(const RunView& view) {
    const double dt = view.description.dt, limit = view.limit->limit;
    if (limit == 0) return {Lamp::bad, "unstable at any dt: the energy grows", {}};
    if (dt > limit) return {Lamp::bad, "unstable: " + of_limit(dt, limit), {}};
    return below_limit(dt, limit, view.resolution);
}

StepVerdict without_notes(const RunView& view) {
    if (chooses_its_steps(view.description))
        return {Lamp::good, "step size chosen by the method",
                "the method keeps its tolerance; dt is the time between two frames"};
    if (!view.limit) return {Lamp::none, "stability limit unknown", "linear theory does not cover this scene"};
    StepVerdict verdict = against_limit(view);
    verdict.tooltip = tooltip_of(*view.limit, view.resolution);
    return verdict;
}

}  // namespace

StepVerdict step_verdict(const RunView& view) {
    StepVerdict verdict = without_notes(view);
    if (!view.notes.empty() && verdict.lamp != Lamp::bad) verdict.lamp = Lamp::caution;
    return verdict;
}

}  // namespace steplab::ui
