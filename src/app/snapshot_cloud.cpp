#include "app/snapshot_cloud.hpp"

#include "io/interruption.hpp"

#include <algorithm>
#include <cmath>

namespace steplab {

namespace {

/// The cloud that the window would be asked for, as nearly as it can be: the first spread over the run's own value.
Cloud nearest_cloud(const RunDescription& description, std::size_t runs, const std::vector<Spread>& spreads) {
    Cloud cloud{.runs = runs, .width = 0};
    if (spreads.empty()) return cloud;
    const auto& [name, from, to] = spreads.front();
    cloud.spread = name;
    if (description.scene.contains(name) && description.scene[name] == 0) return cloud;
    const double value = description.scene.contains(name) ? description.scene[name] : description.dt;
    cloud.width = std::max(std::abs(from - value), std::abs(to - value)) / std::abs(value);
    return cloud;
}

}  // namespace

SnapshotCloud::SnapshotCloud(const RunDescription& description, std::size_t runs, const std::vector<Spread>& spreads)
    : segments_{{0, description}},
      cloud_(nearest_cloud(description, runs, spreads)),
      companions_(runs, [spreads, runs](const RunDescription& run, std::size_t companion) {
          return spread_run(run, spreads, companion, runs);
      }) {
    companions_.go_to(0, segments_);
}

void SnapshotCloud::put_into(RunView& view) {
    companions_.go_to(view.frame.step, segments_, [] {
        check_interruption();
        return false;
    });
    view.cloud = cloud_;
    view.cloud_reading = companions_.look(view.frame);
}

}  // namespace steplab
