#pragma once

#include "core/diagnostics.hpp"
#include "core/vec3.hpp"
#include "session/step_samples.hpp"
#include "sim/run/simulation.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace steplab {

/// What plots show of a run at one of its steps.
struct Sample {
    /// Of a particle that is followed.
    struct Particle {
        Vec3 displacement;  ///< from its rest position, or its first one where it has none [m]
        Vec3 velocity;      ///< [m/s]
        std::optional<Vec3> exact_displacement = {};
    };

    std::uint64_t step = 0;
    double time = 0;          ///< [s]
    double kinetic = 0;       ///< [J]
    double potential = 0;     ///< [J]
    double energy_error = 0;  ///< signed [J]
    Vec3 momentum;            ///< [kg m/s]
    double largest_displacement = 0;
    std::optional<double> error = {};  ///< largest distance of a particle from the exact solution [m]
    static constexpr std::size_t most_particles = 8;
    std::vector<std::optional<Particle>> particles = {};  ///< in their order; those at the end may be missing

    /// Of the one in this place; null: not known.
    const Particle* particle(std::size_t place = 0) const {
        return place < particles.size() && particles[place] ? &*particles[place] : nullptr;
    }
};

/// The numbers of the particles that samples tell of: first the one that views tell about.
using TrackedParticles = std::vector<std::size_t>;

/// Up to Sample::most_particles, each once; none without a first one.
TrackedParticles tracked_particles(std::optional<std::size_t> first, std::span<const std::size_t> others);

/// One without a particle.
Sample sample_of(std::uint64_t step, double time, const Diagnostics& measured);

using SampleSeries = SampleSeriesOf<Sample>;

/// Samples of a run, with what some particles do.
class RunSamples {
public:
    static constexpr std::size_t most = StepSamples<Sample>::most;

    /// Of a scene of so many particles.
    explicit RunSamples(std::size_t particles) : rows_(first_spacing(particles)) {}

    /// How many steps lie between two samples.
    std::uint64_t spacing() const { return rows_.spacing(); }
    /// Steps from here to the next one.
    std::uint64_t to_next(std::uint64_t step) const { return rows_.to_next(step); }
    /// Takes one of the run where it stands, if one belongs there and is not known.
    void offer(const Simulation& run);
    /// Takes one even if it is known.
    void take_again(const Simulation& run);
    /// Takes one, unless it is known or there are to be fewer.
    void put(const Sample& sample);
    /// Takes over those of the same run up to this step that are not known, and is no denser than they are.
    void take(const RunSamples& same, std::uint64_t until);
    /// From now on these particles of the run are followed; what is known of others is forgotten.
    void follow(const TrackedParticles& particles);
    const TrackedParticles& followed() const { return particles_; }
    /// Takes away those that lie behind this step.
    std::vector<Sample> cut(std::uint64_t step) { return rows_.cut(step + 1); }
    /// Takes all away: the start has become another.
    void clear() { rows_.cut(0); }
    /// True if one that belongs up to this step is not known, or not of all particles that are followed.
    bool lack(std::uint64_t until) const;
    /// Puts such back, that told of these particles.
    void append(std::vector<Sample> samples, const TrackedParticles& followed);
    std::span<const Sample> all() const { return rows_.all(); }
    /// Copies what is new there.
    void put_into(SampleSeries& series) const { rows_.put_into(series); }

private:
    bool wants(std::uint64_t step) const;
    bool is_whole(const Sample& sample) const;

    StepSamples<Sample> rows_;
    TrackedParticles particles_;
};

}  // namespace steplab
