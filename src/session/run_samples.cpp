#include "session/run_samples.hpp"

#include <algorithm>
#include <bit>

namespace steplab {
namespace {

/// A sample takes as long as some steps of a cheap method; of a scene so large it is taken at every step still.
constexpr std::size_t particles_at_every_step = 5000;

Sample sample_of(const Simulation& run, std::optional<std::size_t> particle) {
    const Diagnostics measured = run.diagnostics();
    Sample sample = steplab::sample_of(run.step(), run.time(), measured);
    if (!particle || *particle >= run.particles()) return sample;
    sample.particle = {run.displacement(*particle), run.state().velocity.at(*particle)};
    if (const auto exact = run.exact_motion(*particle))
        sample.particle->exact_displacement = exact->displacement(run.time());
    return sample;
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

std::uint64_t first_spacing(std::size_t particles) {
    return std::bit_ceil(std::max<std::size_t>(1, particles / particles_at_every_step));
}

bool RunSamples::wants(std::uint64_t step) const {
    if (!rows_.belongs(step)) return false;
    const Sample* const known = rows_.at(step);
    return !known || (particle_ && !known->particle);
}

void RunSamples::offer(const Simulation& run) {
    if (wants(run.advanced().step)) put(sample_of(run, particle_));
}

void RunSamples::take_again(const Simulation& run) { rows_.put(sample_of(run, particle_)); }

void RunSamples::put(const Sample& sample) {
    if (wants(sample.step)) rows_.put(sample);
}

void RunSamples::take(const RunSamples& same, std::uint64_t until) {
    rows_.thin_to(same.spacing());
    for (const Sample& sample : same.all()) {
        if (sample.step <= until) put(sample);
    }
}

void RunSamples::append(std::vector<Sample> samples, std::optional<std::size_t> followed) {
    for (Sample& sample : samples) {
        if (followed != particle_) sample.particle.reset();
    }
    rows_.append(samples);
}

bool RunSamples::lack(std::uint64_t until) const {
    const auto all = rows_.all();
    const auto end = std::upper_bound(all.begin(), all.end(), until,
                                      [](std::uint64_t step, const Sample& sample) { return step < sample.step; });
    const auto known = static_cast<std::uint64_t>(end - all.begin());
    return known < until / spacing() + 1 ||
           (particle_ && std::any_of(all.begin(), end, [](const Sample& sample) { return !sample.particle; }));
}

void RunSamples::follow(std::optional<std::size_t> particle) {
    if (particle == particle_) return;
    particle_ = particle;
    rows_.edit([](Sample& sample) { sample.particle.reset(); });
}

}  // namespace steplab
