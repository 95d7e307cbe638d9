#include "app/commands/pictured_errors.hpp"

#include "session/compared.hpp"

namespace steplab {

void PicturedErrors::add(const Simulation& run) {
    references_.push_back({ReferenceMotion(run.description()), run.diagnostics().momentum});
}

SessionErrors PicturedErrors::of(const std::vector<const Simulation*>& runs) {
    SessionErrors errors{.time = runs.front()->time()};
    for (std::size_t i = 0; i < runs.size(); ++i) errors.runs.push_back(compared_with(references_[i], *runs[i]));
    errors.exact = references_.front().motion.is_exact();
    errors.how = references_.front().motion.how();
    return errors;
}

std::optional<Compared> PicturedErrors::compared_with(Reference& reference, const Simulation& run) {
    if (run.divergence()) return std::nullopt;
    const ReferenceMoment there = reference.motion.at(run.time());
    return compared(moment_of(run, reference.start_momentum), there, reference.motion.is_exact());
}

}  // namespace steplab
