#include "app/commands/snapshot_ensemble.hpp"

#include "core/interruption.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string_view>

namespace steplab {

LiveEnsembleOptions nearest_live_ensemble(const RunDescription& description, std::size_t runs,
                                          const std::vector<ParameterRange>& ranges) {
    LiveEnsembleOptions ensemble{.runs = runs, .width = 0};
    if (ranges.empty()) return ensemble;
    const auto& [name, from, to] = ranges.front();
    const std::vector<std::string_view> known = perturbable(description);
    ensemble.otherwise = ranges.size() > 1 || std::find(known.begin(), known.end(), name) == known.end();
    if (ensemble.otherwise) return ensemble;
    const double value = description.scene.contains(name) ? description.scene[name] : description.dt;
    ensemble.spread = name;
    ensemble.width = std::abs(to - from) / 2 / std::abs(value);
    // The decimal ends of a range are rounded, each by half of epsilon.
    const double middle = std::abs((from + to) / 2 - value) / std::abs(value);
    ensemble.otherwise =
        middle > std::numeric_limits<double>::epsilon() || ensemble.width > LiveEnsembleOptions::most_width;
    return ensemble;
}

SnapshotEnsemble::SnapshotEnsemble(const RunDescription& description, std::size_t runs,
                                   const std::vector<ParameterRange>& ranges)
    : segments_{{0, description}},
      ensemble_(nearest_live_ensemble(description, runs, ranges)),
      live_ensemble_(runs, [ranges, runs](const RunDescription& run, std::size_t member) {
          return run_in_range(run, ranges, member, runs);
      }) {
    go_to(0);
}

void SnapshotEnsemble::put_into(RunView& view) {
    go_to(view.frame.step);
    view.ensemble = ensemble_;
    view.ensemble_spread = live_ensemble_.observe(view.frame);
}

void SnapshotEnsemble::go_to(std::uint64_t step) {
    live_ensemble_.go_to(step, segments_, [] {
        check_interruption();
        return false;
    });
}

}  // namespace steplab
