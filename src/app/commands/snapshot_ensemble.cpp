#include "app/commands/snapshot_ensemble.hpp"

#include "io/interruption.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string_view>

namespace steplab {

Cloud nearest_cloud(const RunDescription& description, std::size_t runs, const std::vector<Spread>& spreads) {
    Cloud cloud{.runs = runs, .width = 0};
    if (spreads.empty()) return cloud;
    const auto& [name, from, to] = spreads.front();
    const std::vector<std::string_view> known = spreadable(description);
    cloud.otherwise = spreads.size() > 1 || std::find(known.begin(), known.end(), name) == known.end();
    if (cloud.otherwise) return cloud;
    const double value = description.scene.contains(name) ? description.scene[name] : description.dt;
    cloud.spread = name;
    cloud.width = std::abs(to - from) / 2 / std::abs(value);
    // The ends as somebody writes them down are rounded, each by half of epsilon.
    const double middle = std::abs((from + to) / 2 - value) / std::abs(value);
    cloud.otherwise = middle > std::numeric_limits<double>::epsilon() || cloud.width > Cloud::most_width;
    return cloud;
}

SnapshotCloud::SnapshotCloud(const RunDescription& description, std::size_t runs, const std::vector<Spread>& spreads)
    : segments_{{0, description}},
      cloud_(nearest_cloud(description, runs, spreads)),
      companions_(runs, [spreads, runs](const RunDescription& run, std::size_t companion) {
          return spread_run(run, spreads, companion, runs);
      }) {
    go_to(0);
}

void SnapshotCloud::put_into(RunView& view) {
    go_to(view.frame.step);
    view.cloud = cloud_;
    view.cloud_reading = companions_.look(view.frame);
}

void SnapshotCloud::go_to(std::uint64_t step) {
    companions_.go_to(step, segments_, [] {
        check_interruption();
        return false;
    });
}

}  // namespace steplab
