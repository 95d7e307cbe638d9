#include "ui/plot/scene_laws.hpp"

#include "sim/run/mode_frequencies.hpp"

#include <utility>

namespace steplab::ui {
namespace {

bool same_scene(const RunDescription& a, const RunDescription& b) { return a.model == b.model && a.scene == b.scene; }

}  // namespace

void SceneLaws::follow(const RunDescription& description) {
    if (of_ && same_scene(*of_, description)) return;
    *this = SceneLaws();
    of_ = description;
}

const std::optional<std::vector<double>>& SceneLaws::modes(const RunDescription& description) {
    follow(description);
    if (!std::exchange(modes_known_, true)) modes_ = mode_frequencies(description, most_particles);
    return modes_;
}

const std::vector<PairLaw>& SceneLaws::pairs(const RunDescription& description) {
    follow(description);
    if (!std::exchange(pairs_known_, true)) pairs_ = pair_laws(description);
    return pairs_;
}

}  // namespace steplab::ui
