#include "ui/plot/history.hpp"

#include <algorithm>
#include <cmath>

namespace steplab::ui {
namespace {

/// Every second one, the first and the last always.
template <class Value>
void halve(std::vector<Value>& values) {
    const Value last = values.back();
    const std::size_t count = values.size();
    for (std::size_t i = 0; 2 * i < count; ++i) values[i] = values[2 * i];
    values.resize((count + 1) / 2);
    if (count % 2 == 0) values.push_back(last);
}

}  // namespace

double component(Vec3 vector, int axis) { return axis == 0 ? vector.x : axis == 1 ? vector.y : vector.z; }

void History::record(const RunView& view) {
    if (run_ != view.run) begin(view);
    follow(view);
    std::erase_if(reached_, [&](const Reached& before) { return before.step >= view.frame.step; });
    Reached now = reached_.empty() ? Reached{} : reached_.back();
    now.step = view.frame.step;
    const auto& samples = view.series.samples;
    for (const Sample& sample : samples) {
        if (sample.step <= now.step) now.reach_to(sample.largest_displacement, sample.error);
    }
    if (samples.empty()) now.reach_to(view.diagnostics.max_displacement, view.diagnostics.error);
    reached_.push_back(now);
    if (reached_.size() >= RunSamples::most) halve(reached_);
}

void History::Reached::reach_to(double displacement, std::optional<double> error) {
    farthest = std::max(farthest, displacement);
    worst = std::max(worst, error.value_or(0));
}

void History::begin(const RunView& view) {
    *this = History();
    run_ = view.run;
}

/// By the samples of the run where it has some: the same ones at any rate of views.
void History::follow(const RunView& view) {
    const auto particle = view.tracked ? std::optional(view.tracked->particle) : std::nullopt;
    const auto& samples = view.series.samples;
    const bool sampled = particle && !samples.empty() && samples.back().particle();
    if (particle != particle_ || sampled) reach_ = {};
    if (particle != particle_) particle_ = particle;
    for (const Sample& sample : samples) {
        for (std::size_t place = 0; sampled && place < sample.particles.size(); ++place) {
            if (sample.particle(place)) reach_to(sample.particle(place)->displacement);
        }
    }
    if (view.tracked && !sampled) reach_to(view.tracked->displacement);
    if (particle && reach_ == Vec3{} && *particle < view.frame.velocities.size())
        lean_to(view.frame.velocities[*particle]);
}

/// Where it is about to go, before it has moved.
void History::lean_to(Vec3 velocity) {
    const auto size = [&](int axis) { return std::abs(component(velocity, axis)); };
    for (int axis = 0; axis < 3; ++axis) {
        if (size(axis) > 1.2 * size(direction_)) direction_ = axis;
    }
}

/// Another axis must be clearly ahead, so that the plots do not alternate between two of similar size.
void History::reach_to(Vec3 u) {
    if (reach_ == Vec3{}) direction_ = 1;
    reach_ = {std::max(reach_.x, std::abs(u.x)), std::max(reach_.y, std::abs(u.y)), std::max(reach_.z, std::abs(u.z))};
    for (int axis = 0; axis < 3; ++axis) {
        if (component(reach_, axis) > 1.2 * component(reach_, direction_)) direction_ = axis;
    }
}

}  // namespace steplab::ui
