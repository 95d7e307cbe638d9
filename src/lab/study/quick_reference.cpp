#include "lab/study/quick_reference.hpp"

#include "core/error.hpp"
#include "lab/study/distances.hpp"
#include "sim/catalogue.hpp"
#include "sim/run/memory.hpp"
#include "sim/run/simulation.hpp"
#include "sim/run/starting.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace steplab {
namespace {

constexpr const char* quick_method = "dop853";
constexpr double coarsest_tolerance = 1e-5, finest_tolerance = 1e-14, finer = 1e-2;
/// What an evaluation of the force takes however few particles there are, in terms.
constexpr double terms_of_a_call = 300;

struct QuickRun {
    State<double> state;
    double evaluations = 0;
};

/// None if it diverges, or if the method does not take the scene.
std::optional<QuickRun> quick_run(const RunDescription& scene, double time, double tolerance) try {
    RunDescription run = with_method(scene, quick_method);
    run.precision = Precision::double_;
    run.dt = time;
    run.method_parameters.set("tolerance", tolerance);
    Simulation simulation(run);
    simulation.advance(1);
    if (simulation.divergence()) return std::nullopt;
    return QuickRun{simulation.state(), static_cast<double>(simulation.evaluations())};
} catch (const UsageError&) {
    return std::nullopt;
}

Reference as_quick_reference(QuickRun run, double time, double error, double tolerance) {
    Reference reference;
    reference.how =
        fmt::format("{} in double with tolerance {:.0e}; error estimated by a run with 100 times the tolerance",
                    quick_method, tolerance);
    const double rounding = rounding_of(run.state.displacement);
    reference.moments.push_back({time, std::move(run.state), error + rounding});
    return reference;
}

}  // namespace

std::optional<Reference> quick_reference(const RunDescription& scene, double time, double most_terms) {
    const double terms = model_of(scene).particles(scene.scene) + interacting_pairs(plan_of(scene)) + terms_of_a_call;
    std::optional<Reference> best;
    std::optional<QuickRun> coarse;
    for (double tolerance = coarsest_tolerance; tolerance > finest_tolerance; tolerance *= finer) {
        auto fine = quick_run(scene, time, tolerance);
        if (!fine) break;
        if (coarse) {
            const double error = largest_distance(coarse->state.displacement, fine->state.displacement);
            if (!std::isfinite(error) || (best && error > best->moments.back().error)) break;  // limited by rounding
            best = as_quick_reference(*fine, time, error, tolerance);
            const double growth = std::max(2.0, fine->evaluations / coarse->evaluations);
            if (growth * fine->evaluations * terms > most_terms) break;
        }
        coarse = std::move(fine);
    }
    return best;
}

}  // namespace steplab
