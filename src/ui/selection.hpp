#pragma once

#include "core/particle_list.hpp"
#include "session/worker.hpp"

#include <cstddef>
#include <span>
#include <utility>
#include <vector>

namespace steplab::ui {

/// The particles that are selected: first the one that views tell about (event::Track), then others.
class Selection {
public:
    Selection() = default;
    /// These besides the first one.
    explicit Selection(ParticleList others) : others_(std::move(others)) {}

    /// Those besides the first one.
    const ParticleList& others() const { return others_; }
    std::vector<std::size_t> all(const RunView& view) const;
    bool contains(std::size_t particle, const RunView& view) const;

    /// This one alone.
    void only(std::size_t particle, EventSink& events);
    /// Adds this one, or takes it away; where it was the first, the next one is.
    void toggle(std::size_t particle, const RunView& view, EventSink& events);
    /// These in place of those before, or, if `added`, besides. The first one stays it where it is among them.
    void take(std::span<const std::size_t> particles, bool added, const RunView& view, EventSink& events);
    /// How many are selected.
    std::size_t count(const RunView& view) const;
    /// Has the samples tell of the others, too (event::AlsoTrack), if those of the view do not. To be called in every
    /// frame; `is_new`: the view has come since the last one.
    void follow(const RunView& view, bool is_new, EventSink& events);
    /// None but the first one.
    void clear() { others_ = {}; }

private:
    ParticleList others_;
    TrackedParticles asked_;  ///< of samples
};

/// The mass of a particle in kg; 0 where it is not known.
double mass_of(const RunView& view, std::size_t particle);

/// The mass that the scene itself gives, if it is one for all particles: that of those that are not altered. Else
/// `otherwise`.
double usual_mass(const RunView& view, double otherwise);

/// Of several particles at one time: centre of mass and mean velocity weighted by mass, or, where masses are not known,
/// the means of all.
struct Middle {
    Vec3 position, velocity;
};
Middle middle_of(const RunView& view, std::span<const std::size_t> particles);

}  // namespace steplab::ui
