#pragma once

#include "core/diagnostics.hpp"
#include "core/vec3.hpp"
#include "sim/run/simulation.hpp"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace steplab {

/// What plots show of a run at one of its steps.
struct Sample {
    /// Of the particle that is followed.
    struct Particle {
        Vec3 displacement;  ///< from its reference position [m]
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
    std::optional<Particle> particle = {};
};

/// One without a particle.
Sample sample_of(std::uint64_t step, double time, const Diagnostics& measured);

/// A series of samples as a view holds it.
struct SampleSeries {
    std::vector<Sample> samples = {};
    std::shared_ptr<const int> stretch = {};  ///< since when nothing but its end has changed
};

/// RunSamples of a run at the multiples of a number of steps, so that the same run gives the same ones however it is
/// played. In bounded memory: when they are too many, every second one is left out, and so on from then.
class RunSamples {
public:
    static constexpr std::size_t most = 8192;

    /// Of a scene of so many particles: where a sample takes as long as some steps, there are fewer.
    explicit RunSamples(std::size_t particles);

    /// How many steps lie between two samples.
    std::uint64_t spacing() const { return spacing_; }
    /// Steps from here to the next one.
    std::uint64_t to_next(std::uint64_t step) const { return spacing_ - step % spacing_; }
    /// Takes one of the run where it stands, if one belongs there and is not known.
    void offer(const Simulation& run);
    /// Takes one, unless it is known or there are to be fewer.
    void put(const Sample& sample);
    /// From now on a particle is followed; what is known of another one is forgotten.
    void follow(std::optional<std::size_t> particle);
    std::optional<std::size_t> followed() const { return particle_; }
    /// Takes away those that lie behind this step.
    std::vector<Sample> cut(std::uint64_t step);
    /// Puts such back.
    void append(std::span<const Sample> samples);
    std::span<const Sample> all() const { return samples_; }
    /// Copies what is new there.
    void put_into(SampleSeries& series) const;

private:
    bool wants(std::uint64_t step) const;
    void thin_out();
    void changed() { stretch_ = std::make_shared<const int>(); }

    std::uint64_t spacing_;
    std::optional<std::size_t> particle_;
    std::vector<Sample> samples_;
    std::shared_ptr<const int> stretch_ = std::make_shared<const int>();
};

}  // namespace steplab
