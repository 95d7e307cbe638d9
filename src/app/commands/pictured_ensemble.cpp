#include "app/commands/pictured_ensemble.hpp"

#include "core/interruption.hpp"

namespace steplab {

PicturedEnsemble::PicturedEnsemble(const RunDescription& description, std::size_t runs,
                                   const std::vector<ParameterRange>& ranges)
    : segments_{{0, description}},
      ensemble_(nearest_live_ensemble(description, runs, ranges)),
      live_ensemble_(runs, [ranges, runs](const RunDescription& run, std::size_t member) {
          return run_in_range(run, ranges, member, runs);
      }) {
    go_to(0);
}

void PicturedEnsemble::sample(const Simulation& run) {
    go_to(run.step());
    spread_.offer(run, live_ensemble_);
}

void PicturedEnsemble::put_into(RunView& view) {
    go_to(view.frame.step);
    view.ensemble = ensemble_;
    view.ensemble_spread = live_ensemble_.observe(view.frame);
    spread_.put_into(view.spread);
}

void PicturedEnsemble::go_to(std::uint64_t step) {
    live_ensemble_.go_to(step, segments_, [] {
        check_interruption();
        return false;
    });
}

std::optional<PicturedEnsemble> pictured_ensemble(const EnsembleOptions& options, const RunDescription& description) {
    if (!options.is_given()) return std::nullopt;
    return PicturedEnsemble(description, options.count(), options.ranges(description));
}

}  // namespace steplab
