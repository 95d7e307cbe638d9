#include "ui/trail.hpp"

#include <algorithm>

namespace steplab::ui {
namespace {

constexpr std::size_t most_places = 1500;

}  // namespace

void Trails::record(const RunView& view, bool shown) {
    if (!view.tracked || !view.frame.shape) return;
    if (run_ != view.run || view.frame.step < step_) trails_.clear();
    run_ = view.run;
    const bool same_moment = view.frame.step == step_;
    step_ = view.frame.step;
    select(view.tracked->particle, shown);
    for (Trail& trail : trails_) {
        if (same_moment && !trail.places.empty()) continue;
        trail.places.push_back(view.frame.positions[trail.particle]);
        if (trail.places.size() > most_places) trail.places.pop_front();
    }
    render::Trails all;
    for (const Trail& trail : trails_) {
        if (trail.places.size() < 2) continue;
        all.emplace_back(trail.places.begin(), trail.places.end());
        for (Vec3& place : all.back()) place = view.frame.drawn_at(trail.particle, place);
    }
    places_ = all.empty() ? nullptr : std::make_shared<const render::Trails>(std::move(all));
}

void Trails::select(std::size_t particle, bool shown) {
    const auto is_it = [particle](const Trail& trail) { return trail.particle == particle; };
    if (!shown) std::erase_if(trails_, [&](const Trail& trail) { return !is_it(trail); });
    const auto known = std::find_if(trails_.begin(), trails_.end(), is_it);
    if (known == trails_.end()) {
        trails_.push_back({particle});
    } else {
        std::rotate(known, known + 1, trails_.end());
    }
    if (trails_.size() > most_particles) trails_.erase(trails_.begin());
}

}  // namespace steplab::ui
