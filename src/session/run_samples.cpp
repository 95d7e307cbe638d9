#include "session/run_samples.hpp"

#include <algorithm>
#include <bit>
#include <iterator>

namespace steplab {
namespace {

/// A sample takes as long as some steps of a cheap method; of a scene so large it is taken at every step still.
constexpr std::size_t particles_at_every_step = 5000;

Sample sample_of(const Simulation& run, std::optional<std::size_t> particle) {
    const Diagnostics measured = run.diagnostics();
    Sample sample = steplab::sample_of(run.step(), run.time(), measured);
    if (!particle || *particle >= run.particles()) return sample;
    const State<double>& state = run.state();
    sample.particle = {state.displacement.at(*particle), state.velocity.at(*particle)};
    if (const auto exact = run.exact_position(*particle, run.time()))
        sample.particle->exact_displacement = *exact - run.shape()->rest[*particle];
    return sample;
}

template <class Sampled>
auto place_of(Sampled& samples, std::uint64_t step) {
    return std::lower_bound(samples.begin(), samples.end(), step,
                            [](const Sample& sample, std::uint64_t wanted) { return sample.step < wanted; });
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

RunSamples::RunSamples(std::size_t particles)
    : spacing_(std::bit_ceil(std::max<std::size_t>(1, particles / particles_at_every_step))) {}

bool RunSamples::wants(std::uint64_t step) const {
    if (step % spacing_ != 0) return false;
    const auto place = place_of(samples_, step);
    const bool known = place != samples_.end() && place->step == step;
    return !known || (particle_ && !place->particle);
}

void RunSamples::offer(const Simulation& run) {
    if (wants(run.advanced().step)) put(sample_of(run, particle_));
}

void RunSamples::put(const Sample& sample) {
    if (!wants(sample.step)) return;
    const auto place = place_of(samples_, sample.step);
    if (place != samples_.end()) changed();
    if (place != samples_.end() && place->step == sample.step) {
        *place = sample;
    } else {
        samples_.insert(place, sample);
    }
    thin_out();
}

void RunSamples::follow(std::optional<std::size_t> particle) {
    if (particle == particle_) return;
    particle_ = particle;
    for (Sample& sample : samples_) sample.particle.reset();
    changed();
}

std::vector<Sample> RunSamples::cut(std::uint64_t step) {
    const auto first = place_of(samples_, step + 1);
    if (first == samples_.end()) return {};
    std::vector<Sample> rest(first, samples_.end());
    samples_.erase(first, samples_.end());
    changed();
    return rest;
}

void RunSamples::append(std::span<const Sample> samples) {
    for (const Sample& sample : samples) {
        if (sample.step % spacing_ == 0 && (samples_.empty() || sample.step > samples_.back().step))
            samples_.push_back(sample);
    }
    thin_out();
}

void RunSamples::thin_out() {
    while (samples_.size() >= most) {
        spacing_ *= 2;
        std::erase_if(samples_, [this](const Sample& sample) { return sample.step % spacing_ != 0; });
        changed();
    }
}

void RunSamples::put_into(SampleSeries& series) const {
    if (series.stretch != stretch_ || series.samples.size() > samples_.size()) {
        series = {samples_, stretch_};
        return;
    }
    const auto known = static_cast<std::ptrdiff_t>(series.samples.size());
    series.samples.insert(series.samples.end(), samples_.begin() + known, samples_.end());
}

}  // namespace steplab
