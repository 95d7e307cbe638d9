#include "sim/run/remedy.hpp"

#include "sim/catalogue.hpp"

namespace steplab {
namespace {

// A nonlinear scene stiffens as it moves: a method close to its linear limit is no remedy.
constexpr double share_of_limit = 0.9;

bool keeps_stable(const RunDescription& description) {
    const auto limit = stability_limit(description);
    return limit && description.dt <= share_of_limit * limit->limit;
}

}  // namespace

std::optional<std::string> stable_method(const RunDescription& description) {
    std::optional<std::string> best;
    double best_cost = infinity;
    for (const Method& entry : methods()) {
        // a remedy keeps the kind of method: explicit, in steps of dt
        if (entry.info.curiosity || entry.info.implicit || entry.info.adaptive || entry.info.id == description.method)
            continue;
        const RunDescription candidate = with_method(description, entry.info.id);
        const double cost = evaluations_per_step(entry.info, candidate.method_parameters);
        if (cost >= best_cost || !keeps_stable(candidate)) continue;
        best = candidate.method;
        best_cost = cost;
    }
    return best;
}

}  // namespace steplab
