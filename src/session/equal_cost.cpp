#include "session/equal_cost.hpp"

#include "core/error.hpp"
#include "sim/catalogue.hpp"
#include "sim/run/simulation.hpp"

#include <boost/math/tools/toms748_solve.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>

namespace steplab {

namespace {

/// Steps of dt after which a measurement is long enough.
constexpr std::uint64_t most_steps = 400;
/// Of the logarithm of the cost: where a search ends, and what is still called equal.
constexpr double near_enough = 0.01, equal_enough = 0.1;
/// Evaluations of a search at most.
constexpr std::uintmax_t most_tries = 12;

/// Evaluations after which a measurement is long enough: fewer where each takes long.
std::uint64_t enough_evaluations(std::size_t particles) {
    return std::clamp<std::uint64_t>(200'000 / particles, 200, 2000);
}

/// None where it diverges or takes no step.
std::optional<double> measured(const RunDescription& run) {
    Simulation simulation(run);
    const std::uint64_t at_start = simulation.evaluations(),
                        enough = at_start + enough_evaluations(simulation.particles());
    while (simulation.evaluations() < enough && simulation.step() < most_steps && !simulation.divergence())
        simulation.advance(1);
    if (simulation.divergence() || !(simulation.time() > 0)) return std::nullopt;
    return static_cast<double>(simulation.evaluations() - at_start) / simulation.time();
}

/// Where a search looks, in decimal logarithms: from the costly end on in strides.
struct SearchedRange {
    double fine, coarse, stride;
};

/// Looks for where a run costs as much as another one.
template <class Set>
class CostSearch {
public:
    CostSearch(RunDescription run, double cost, Set set) : run_(std::move(run)), cost_(cost), set_(set) {}

    /// By strides to the first place where it costs no more, and between the last two by TOMS 748 (Alefeld, Potra, Shi,
    /// ACM Trans. Math. Softw. 21 (1995) 327). Throws UsageError if no value has that cost.
    RunDescription found(const SearchedRange& range) {
        double costly = range.fine, above = excess(costly);
        while (above > near_enough) {
            const double next = costly + range.stride;
            if (next > range.coarse + 0.5 * range.stride) fail();
            const double below = excess(next);
            if (below <= 0) return between(costly, next, above, below);
            costly = next;
            above = below;
        }
        return kept();
    }

private:
    /// Of the logarithm of its cost; beyond where it can run there is nothing to be found.
    double excess(double logarithm) {
        set_(run_, std::pow(10, logarithm));
        const auto cost = measured(run_);
        if (!cost) fail();
        if (least_ == 0 || *cost < least_) least_ = *cost;
        excess_ = std::log(*cost / cost_);
        return excess_;
    }
    RunDescription between(double costly, double cheap, double above, double below) {
        std::uintmax_t tries = most_tries;
        const auto of = [this](double logarithm) {
            const double found = excess(logarithm);
            return std::abs(found) < near_enough ? 0 : found;
        };
        const auto narrow = [](double a, double b) { return std::abs(a - b) < 1e-3; };
        const auto [low, high] = boost::math::tools::toms748_solve(of, costly, cheap, above, below, narrow, tries);
        excess(0.5 * (low + high));
        return kept();
    }
    RunDescription kept() const {
        if (std::abs(excess_) > equal_enough) fail();
        return run_;
    }
    [[noreturn]] void fail() const {
        const std::string what =
            least_ > cost_ ? fmt::format("it costs {:.3g} at least", least_) : std::string("no setting has that cost");
        throw UsageError(fmt::format("{} cannot cost {:.3g} force evaluations per simulated second in this scene: {}",
                                     run_.method, cost_, what));
    }

    RunDescription run_;
    double cost_;
    Set set_;
    double excess_ = 0, least_ = 0;  ///< of the last measurement; the least cost so far
};

RunDescription with_tolerance_of_cost(const RunDescription& run, double cost) {
    CostSearch search(run, cost, [](RunDescription& tried, double tolerance) {
        tried.method_parameters.set("tolerance", tolerance);
    });
    return search.found({-15, -1, 2});
}

/// Solving takes fewer iterations the smaller dt is, and more of them than dt saves where it is large.
RunDescription with_dt_of_cost(const RunDescription& run, double cost) {
    const double guess = std::log10(run.dt);
    CostSearch search(run, cost, [](RunDescription& tried, double dt) { tried.dt = dt; });
    return search.found({guess - 1.5, guess + 1.5, 0.5});
}

/// True if the evaluations of a step are known without taking it.
bool has_known_cost(const RunDescription& run) { return !chooses_its_steps(run) && !method(run.method).info.implicit; }

}  // namespace

double evaluations_per_second(const RunDescription& run) {
    if (!has_known_cost(run)) return measured(run).value_or(0);
    return evaluations_per_step(method(run.method).info, run.method_parameters) / std::abs(run.dt);
}

RunDescription at_equal_cost(const RunDescription& run, const RunDescription& other) {
    const double cost = evaluations_per_second(other);
    if (chooses_its_steps(run)) return with_tolerance_of_cost(run, cost);
    RunDescription equal = run;
    equal.dt = evaluations_per_step(method(run.method).info, run.method_parameters) / cost;
    return has_known_cost(run) ? equal : with_dt_of_cost(equal, cost);
}

}  // namespace steplab
