#include "ui/trail.hpp"

namespace steplab::ui {
namespace {

constexpr std::size_t most_places = 1500;

}  // namespace

void Trail::record(const RunView& view) {
    if (!view.tracked || !view.frame.shape) return;
    const bool other = particle_ != view.tracked->particle || run_ != view.run || view.frame.step < step_;
    if (!other && view.frame.step == step_ && !kept_.empty()) return;
    if (other) kept_.clear();
    particle_ = view.tracked->particle;
    run_ = view.run;
    step_ = view.frame.step;
    kept_.push_back(view.frame.shape->rest[*particle_] + view.tracked->displacement);
    if (kept_.size() > most_places) kept_.pop_front();
    places_ = kept_.size() > 1 ? std::make_shared<const std::vector<Vec3>>(kept_.begin(), kept_.end()) : nullptr;
}

}  // namespace steplab::ui
