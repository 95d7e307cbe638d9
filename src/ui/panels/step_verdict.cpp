#include "ui/panels/step_verdict.hpp"

#include "core/number_text.hpp"
#include "ui/widgets/format.hpp"

#include <fmt/format.h>

#include <cmath>
#include <string_view>

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
    const std::string number = frequency_text(steps);
    return fmt::format("{} {} per period", number, number == "1" ? "step" : "steps");
}

/// What a verdict is based on.
struct Basis {
    double omega = 0;  ///< of the fastest oscillation [rad/s]
    double limit = 0;
    std::optional<Resolution> resolution;
    std::optional<double> time;  ///< when the scene was so; none: at rest
};

std::optional<Basis> basis_of(const RunView& view, const PresentLimit* present) {
    if (present && present->limit)
        return Basis{present->oscillation.omega, *present->limit, present->resolution, present->time};
    if (!view.limit) return std::nullopt;
    return Basis{view.limit->omega_max, view.limit->limit, view.resolution, std::nullopt};
}

/// "amplitude kept", "amplitude −3.1 % per period"; the last words are `each`.
std::string damping_text(const Resolution& resolution, std::string_view each) {
    const double change = 100 * (resolution.amplification - 1);
    if (std::abs(change) < 1e-6) return "amplitude kept";
    if (change > 1000 || !std::isfinite(change)) return "amplitude explodes";
    return fmt::format("amplitude {}{} %{}", change > 0 ? "+" : "−", rounded_text(std::abs(change)), each);
}

/// What the first line does not say.
std::string detail_of(double dt, const Basis& basis) {
    if (!basis.resolution) return {};
    const bool named = dt <= basis.limit && !basis.resolution->is_good();  // the steps per period are in the first line
    if (named && std::isinf(basis.limit)) return damping_text(*basis.resolution, " per period");
    if (named)
        return fmt::format("{} of the limit, {}", share_text(dt / basis.limit),
                           damping_text(*basis.resolution, " per period"));
    const std::string steps = frequency_text(basis.resolution->steps_per_period);
    return fmt::format("per period: {} {}, {}", steps, steps == "1" ? "step" : "steps",
                       damping_text(*basis.resolution, ""));
}

std::string when_text(const Basis& basis) {
    if (!basis.time) return "from linear theory for the scene at rest";
    return fmt::format("from linear theory for the scene as it is at t = {} s", reading_text(*basis.time));
}

std::string tooltip_of(const Basis& basis, const RunView& view) {
    std::string text =
        fmt::format("{}\nlargest angular frequency ω_max = {} rad/s", when_text(basis), reading_text(basis.omega));
    if (std::isfinite(basis.limit)) text += fmt::format(", stability limit {} s", reading_text(basis.limit));
    if (basis.time && view.limit && std::abs(view.limit->omega_max - basis.omega) > 0.005 * basis.omega)
        text += fmt::format("; at rest {} rad/s, limit {} s", reading_text(view.limit->omega_max),
                            reading_text(view.limit->limit));
    if (!basis.resolution) return text;
    text += fmt::format("\n{} of that oscillation", steps_text(basis.resolution->steps_per_period));
    if (basis.resolution->error < 1)
        text +=
            fmt::format("; in each, its amplitude is multiplied by {}, and its error grows by {} % of the amplitude",
                        setting_text(basis.resolution->amplification, 3), rounded_text(100 * basis.resolution->error));
    return text;
}

StepVerdict below_limit(double dt, const Basis& basis) {
    if (basis.resolution && !basis.resolution->is_good())
        return {Lamp::caution, "stable, but only " + steps_text(basis.resolution->steps_per_period), {}, {}};
    if (std::isinf(basis.limit)) return {Lamp::good, "stable at any dt", {}, {}};
    const bool close = dt > near_limit * basis.limit;
    const std::string text = (close ? "barely stable: " : "stable: ") + of_limit(dt, basis.limit);
    return {close ? Lamp::caution : Lamp::good, text, {}, {}};
}

StepVerdict against_limit(double dt, const Basis& basis) {
    if (basis.limit == 0) return {Lamp::bad, "unstable at any dt: the energy grows", {}, {}};
    if (dt > basis.limit) return {Lamp::bad, "unstable: " + of_limit(dt, basis.limit), {}, {}};
    return below_limit(dt, basis);
}

StepVerdict without_notes(const RunView& view, const PresentLimit* present) {
    if (chooses_its_steps(view.description))
        return {Lamp::good,
                "step size chosen by the method",
                {},
                "the method keeps its tolerance; dt is the time between two frames"};
    const auto basis = basis_of(view, present);
    if (!basis) return {Lamp::none, "stability limit unknown", {}, "linear theory does not cover this scene"};
    StepVerdict verdict = against_limit(std::abs(view.description.dt), *basis);
    verdict.detail = detail_of(std::abs(view.description.dt), *basis);
    verdict.tooltip = tooltip_of(*basis, view);
    return verdict;
}

}  // namespace

const StepVerdict& longest_verdict() {
    static const StepVerdict longest{.lamp = Lamp::caution,
                                     .text = "barely stable: 0.88 of the limit 8.88e-8 s",
                                     .detail = "0.88 of the limit, amplitude −8.8e-8 % per period",
                                     .tooltip = {}};
    return longest;
}

StepVerdict step_verdict(const RunView& view, const PresentLimit* present) {
    StepVerdict verdict = without_notes(view, present);
    if (!view.notes.empty() && verdict.lamp != Lamp::bad) verdict.lamp = Lamp::caution;
    return verdict;
}

}  // namespace steplab::ui
