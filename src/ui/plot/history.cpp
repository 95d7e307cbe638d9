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

void Course::put(std::uint64_t step, double time, double value) {
    keep(static_cast<std::size_t>(std::lower_bound(steps_.begin(), steps_.end(), step) - steps_.begin()));
    steps_.push_back(step);
    times_.push_back(time);
    values_.push_back(value);
    if (steps_.size() >= most) thin_out();
}

void Course::keep(std::size_t count) {
    steps_.resize(count);
    times_.resize(count);
    values_.resize(count);
}

void Course::thin_out() {
    halve(steps_);
    halve(times_);
    halve(values_);
}

void History::record(const RunView& view) {
    if (run_ != view.run) begin(view);
    follow(view.tracked);
    std::erase_if(reached_, [&](const Reached& before) { return before.step >= view.frame.step; });
    const Reached before = reached_.empty() ? Reached{} : reached_.back();
    reached_.push_back({view.frame.step, std::max(before.farthest, view.diagnostics.max_displacement),
                        std::max(before.worst, view.diagnostics.error.value_or(0))});
    if (reached_.size() >= Course::most) halve(reached_);
}

void History::record_beside(const SessionView& view) {
    const Frame& frame = view.leading.frame;
    if (!frame.ensemble.empty()) spread_.put(frame.step, frame.time, view.leading.ensemble_spread.largest);
    record_ensemble(view.leading);
    if (!view.errors) return;
    if (errors_.size() != view.errors->runs.size()) errors_.assign(view.errors->runs.size(), {});
    for (std::size_t run = 0; run < errors_.size(); ++run) {
        if (const auto& compared = view.errors->runs[run])
            errors_[run].put(frame.step, compared->time, compared->error);
    }
    if (const auto& leading = view.errors->runs.front())
        reference_error_.put(frame.step, leading->time, leading->reference_error);
}

void History::record_ensemble(const RunView& view) {
    const Frame& frame = view.frame;
    if (!view.tracked || frame.ensemble.empty()) return;
    const std::size_t particle = view.tracked->particle;
    const Vec3 rest = frame.positions[particle] - view.tracked->displacement;
    double low = INFINITY, high = -INFINITY;
    for (std::size_t i = particle; i < frame.ensemble.size(); i += frame.positions.size()) {
        const double at = component(frame.ensemble[i] - rest, direction_);
        if (!std::isfinite(at)) continue;
        low = std::min(low, at);
        high = std::max(high, at);
    }
    if (!(low <= high)) return;
    ensemble_.low.put(frame.step, frame.time, low);
    ensemble_.high.put(frame.step, frame.time, high);
}

void History::begin(const RunView& view) {
    *this = History();
    run_ = view.run;
}

void History::follow(const std::optional<Tracked>& tracked) {
    const auto particle = tracked ? std::optional(tracked->particle) : std::nullopt;
    if (particle != particle_) {
        particle_ = particle;
        reach_ = {};
        ensemble_ = {};
    }
    if (!tracked) return;
    const Vec3 u = tracked->displacement;
    reach_ = {std::max(reach_.x, std::abs(u.x)), std::max(reach_.y, std::abs(u.y)), std::max(reach_.z, std::abs(u.z))};
    const int before = direction_;
    // Another axis must be clearly ahead, so that the plots do not alternate between two of similar size.
    for (int axis = 0; axis < 3; ++axis) {
        if (component(reach_, axis) > 1.2 * component(reach_, direction_)) direction_ = axis;
    }
    if (direction_ != before) ensemble_ = {};
}

}  // namespace steplab::ui
