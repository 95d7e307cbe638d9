#include "session/run_samples.hpp"

#include <algorithm>
#include <bit>

namespace steplab {
namespace {

/// A sample takes as long as some steps of a cheap method; of a scene so large it is taken at every step still.
constexpr std::size_t particles_at_every_step = 5000;

Sample::Particle particle_of(const Simulation& run, std::size_t particle) {
    const auto exact = run.exact_motion(particle);
    return {run.displacement(particle), run.state().velocity.at(particle),
            exact ? exact->displacement(run.time()) : std::nullopt};
}

Sample sample_of(const Simulation& run, const TrackedParticles& particles) {
    Sample sample = steplab::sample_of(run.step(), run.time(), run.diagnostics());
    for (const std::size_t particle : particles) sample.particles.emplace_back(particle_of(run, particle));
    return sample;
}

/// What a sample of some particles tells of others.
void retell(Sample& sample, const TrackedParticles& before, const TrackedParticles& now) {
    std::vector<std::optional<Sample::Particle>> found(now.size());
    for (std::size_t i = 0; i < now.size(); ++i) {
        const auto place = std::find(before.begin(), before.end(), now[i]);
        if (const auto* const known = sample.particle(static_cast<std::size_t>(place - before.begin())))
            found[i] = *known;
    }
    sample.particles = std::move(found);
}

}  // namespace

Sample sample_of(std::uint64_t step, double time, const Diagnostics& measured) {
    return {.step = step,
            .time = time,
            .kinetic = measured.kinetic,
            .potential = measured.potential,
            .energy_error = measured.energy_error,
            .momentum = measured.momentum,
            .largest_displacement = measured.max_displacement,
            .error = measured.error};
}

TrackedParticles tracked_particles(std::optional<std::size_t> first, std::span<const std::size_t> others) {
    if (!first) return {};
    TrackedParticles all{*first};
    for (const std::size_t other : others) {
        if (all.size() < Sample::most_particles && std::find(all.begin(), all.end(), other) == all.end())
            all.push_back(other);
    }
    return all;
}

std::uint64_t first_spacing(std::size_t particles) {
    return std::bit_ceil(std::max<std::size_t>(1, particles / particles_at_every_step));
}

bool RunSamples::wants(std::uint64_t step) const {
    if (!rows_.belongs(step)) return false;
    const Sample* const known = rows_.at(step);
    return !known || !is_whole(*known);
}

/// True if it tells of all particles that are followed.
bool RunSamples::is_whole(const Sample& sample) const {
    for (std::size_t place = 0; place < particles_.size(); ++place) {
        if (!sample.particle(place)) return false;
    }
    return true;
}

void RunSamples::offer(const Simulation& run) {
    if (wants(run.advanced().step)) put(sample_of(run, particles_));
}

void RunSamples::take_again(const Simulation& run) { rows_.put(sample_of(run, particles_)); }

void RunSamples::put(const Sample& sample) {
    if (wants(sample.step)) rows_.put(sample);
}

void RunSamples::take(const RunSamples& same, std::uint64_t until) {
    rows_.thin_to(same.spacing());
    for (const Sample& sample : same.all()) {
        if (sample.step <= until) put(sample);
    }
}

void RunSamples::append(std::vector<Sample> samples, const TrackedParticles& followed) {
    for (Sample& sample : samples) retell(sample, followed, particles_);
    rows_.append(samples);
}

bool RunSamples::lack(std::uint64_t until) const {
    const auto all = rows_.all();
    const auto end = std::upper_bound(all.begin(), all.end(), until,
                                      [](std::uint64_t step, const Sample& sample) { return step < sample.step; });
    const auto known = static_cast<std::uint64_t>(end - all.begin());
    return known < until / spacing() + 1 ||
           std::any_of(all.begin(), end, [this](const Sample& sample) { return !is_whole(sample); });
}

void RunSamples::follow(const TrackedParticles& particles) {
    if (particles == particles_) return;
    rows_.edit([&](Sample& sample) { retell(sample, particles_, particles); });
    particles_ = particles;
}

}  // namespace steplab
