#include "ui/selection.hpp"

#include <algorithm>

namespace steplab::ui {

namespace {

bool is_first(std::size_t particle, const RunView& view) { return view.tracked && view.tracked->particle == particle; }

ParticleList without(std::size_t particle, const ParticleList& list) {
    std::vector<std::size_t> rest(list.begin(), list.end());
    std::erase(rest, particle);
    return ParticleList(std::move(rest));
}

}  // namespace

std::vector<std::size_t> Selection::all(const RunView& view) const {
    std::vector<std::size_t> all;
    if (view.tracked) all.push_back(view.tracked->particle);
    for (const std::size_t other : others_) {
        if (other < view.frame.positions.size() && !is_first(other, view)) all.push_back(other);
    }
    return all;
}

bool Selection::contains(std::size_t particle, const RunView& view) const {
    return is_first(particle, view) || others_.contains(particle);
}

void Selection::only(std::size_t particle, EventSink& events) {
    others_ = {};
    events.send(event::Track{particle});
}

void Selection::toggle(std::size_t particle, const RunView& view, EventSink& events) {
    if (is_first(particle, view)) {
        if (others_.empty()) return;
        events.send(event::Track{*others_.begin()});
        others_ = without(*others_.begin(), others_);
    } else if (others_.contains(particle)) {
        others_ = without(particle, others_);
    } else if (!view.tracked) {
        only(particle, events);
    } else {
        std::vector<std::size_t> more(others_.begin(), others_.end());
        more.push_back(particle);
        others_ = ParticleList(std::move(more));
    }
}

void Selection::take(std::span<const std::size_t> particles, bool added, const RunView& view, EventSink& events) {
    std::vector<std::size_t> all(particles.begin(), particles.end());
    if (added) all.insert(all.end(), others_.begin(), others_.end());
    others_ = ParticleList(std::move(all));
    const bool stays = view.tracked && (added || others_.contains(view.tracked->particle));
    if (stays || others_.empty()) {
        if (view.tracked) others_ = without(view.tracked->particle, others_);
        return;
    }
    const std::size_t first = *others_.begin();
    others_ = without(first, others_);
    events.send(event::Track{first});
}

std::size_t Selection::count(const RunView& view) const {
    const std::size_t* const end = std::lower_bound(others_.begin(), others_.end(), view.frame.positions.size());
    const auto others = static_cast<std::size_t>(end - others_.begin());
    if (!view.tracked) return others;
    return others + (std::binary_search(others_.begin(), end, view.tracked->particle) ? 0 : 1);
}

void Selection::follow(const RunView& view, bool is_new, EventSink& events) {
    if (!view.tracked) return;
    TrackedParticles wanted;
    for (const std::size_t* other = others_.begin(); other != others_.end(); ++other) {
        if (wanted.size() + 1 == Sample::most_particles || *other >= view.frame.positions.size()) break;
        if (!is_first(*other, view)) wanted.push_back(*other);
    }
    const auto is_it = [](const Tracked& one, std::size_t particle) { return one.particle == particle; };
    const auto& known = view.also_tracked;
    const bool agrees = std::equal(known.begin(), known.end(), wanted.begin(), wanted.end(), is_it);
    const bool was_asked = asked_ == wanted;
    if (!agrees && (is_new || !was_asked)) events.send(event::AlsoTrack{wanted});
    asked_ = std::move(wanted);
}

double mass_of(const RunView& view, std::size_t particle) {
    if (const auto altered = view.description.alterations.of(particle).mass) return *altered;
    const auto& masses = view.frame.shape->masses;
    return masses.empty() ? view.frame.mass : masses[particle];
}

double usual_mass(const RunView& view, double otherwise) {
    const auto& masses = view.frame.shape->masses;
    if (masses.empty()) return view.frame.mass > 0 ? view.frame.mass : otherwise;
    std::optional<double> usual;
    for (std::size_t i = 0; i < masses.size(); ++i) {
        if (masses[i] == usual || view.description.alterations.of(i).mass) continue;
        if (usual) return otherwise;
        usual = masses[i];
    }
    return usual.value_or(otherwise);
}

Middle middle_of(const RunView& view, std::span<const std::size_t> particles) {
    const bool known = std::all_of(particles.begin(), particles.end(),
                                   [&](std::size_t particle) { return mass_of(view, particle) > 0; });
    Middle sum;
    double all = 0;
    for (const std::size_t particle : particles) {
        const double weight = known ? mass_of(view, particle) : 1;
        sum.position = sum.position + weight * view.frame.positions[particle];
        sum.velocity = sum.velocity + weight * view.frame.velocities[particle];
        all += weight;
    }
    return {(1 / all) * sum.position, (1 / all) * sum.velocity};
}

}  // namespace steplab::ui
