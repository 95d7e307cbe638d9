#include "ui/plot/history.hpp"

#include <algorithm>
#include <cmath>

namespace steplab::ui {
namespace {

constexpr std::size_t most_whole = 8192;
constexpr std::size_t most_recent = 600;

/// `before`: the sample before it.
Sample sample_of(const RunView& view, const Sample& before) {
    Sample sample{.time = view.frame.time,
                  .energy_error = std::abs(view.diagnostics.energy_error),
                  .farthest = std::max(before.farthest, view.diagnostics.max_displacement),
                  .worst = std::max(before.worst, view.diagnostics.error.value_or(0)),
                  .displacement = {},
                  .exact_displacement = {}};
    if (view.tracked) {
        sample.displacement = view.tracked->displacement;
        sample.exact_displacement = view.tracked->exact_displacement;
    }
    return sample;
}

void drop_from(std::vector<Sample>& samples, double time) {
    const auto first =
        std::find_if(samples.begin(), samples.end(), [&](const Sample& sample) { return sample.time >= time; });
    samples.erase(first, samples.end());
}

}  // namespace

double component(Vec3 vector, int axis) { return axis == 0 ? vector.x : axis == 1 ? vector.y : vector.z; }

std::span<const Sample> History::recent() const {
    const std::size_t count = std::min(recent_.size(), most_recent);
    return std::span(recent_).last(count);
}

void History::record(const RunView& view) {
    if (run_ != view.run) begin(view);
    follow(view.tracked);
    forget_from(view.frame.time);
    append(sample_of(view, last()));
}

void History::begin(const RunView& view) {
    *this = History();
    run_ = view.run;
}

void History::forget_from(double time) {
    if (recent_.empty() || recent_.back().time < time) return;
    drop_from(whole_, time);
    drop_from(recent_, time);
}

/// Of the samples left; a long way back only those of the whole run are.
Sample History::last() const {
    if (!recent_.empty()) return recent_.back();
    return whole_.empty() ? Sample{} : whole_.back();
}

void History::follow(const std::optional<Tracked>& tracked) {
    const auto particle = tracked ? std::optional(tracked->particle) : std::nullopt;
    if (particle != particle_) {
        particle_ = particle;
        reach_ = {};
        for (auto* samples : {&whole_, &recent_}) {
            for (Sample& sample : *samples) sample.displacement = sample.exact_displacement = std::nullopt;
        }
    }
    if (!tracked) return;
    const Vec3 u = tracked->displacement;
    reach_ = {std::max(reach_.x, std::abs(u.x)), std::max(reach_.y, std::abs(u.y)), std::max(reach_.z, std::abs(u.z))};
    // Another axis must be clearly ahead, so that the plot does not alternate between two of similar size.
    for (int axis = 0; axis < 3; ++axis) {
        if (component(reach_, axis) > 1.2 * component(reach_, direction_)) direction_ = axis;
    }
}

void History::append(const Sample& sample) {
    recent_.push_back(sample);
    if (recent_.size() >= 2 * most_recent) recent_.erase(recent_.begin(), recent_.end() - most_recent);

    if (++skipped_ < stride_ && !whole_.empty()) return;
    skipped_ = 0;
    whole_.push_back(sample);
    if (whole_.size() < most_whole) return;
    for (std::size_t i = 0; 2 * i < whole_.size(); ++i) whole_[i] = whole_[2 * i];
    whole_.resize(most_whole / 2);
    stride_ *= 2;
}

}  // namespace steplab::ui
