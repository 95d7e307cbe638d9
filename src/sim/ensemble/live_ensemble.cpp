#include "sim/ensemble/live_ensemble.hpp"

#include "core/duration.hpp"
#include "core/error.hpp"
#include "core/flush_subnormals.hpp"
#include "sim/catalogue.hpp"
#include "sim/ensemble/lane_compatible.hpp"
#include "sim/run/memory.hpp"
#include "sim/run/segment.hpp"
#include "sim/run/starting.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace steplab {

namespace {

/// Steps of a particle between two questions whether to stop: some milliseconds at most.
constexpr std::uint64_t steps_of_particles = std::uint64_t{1} << 15;

/// The first of these that can be computed in lanes.
std::span<const StepperSetup> lane_compatible_ones(std::span<const StepperSetup> setups) {
    const std::size_t most = std::min(setups.size(), most_lanes);
    std::size_t count = fits_lanes(setups.front()) ? 1 : 0;
    while (count > 0 && count < most && lane_compatible(setups.front(), setups[count])) ++count;
    return setups.first(count);
}

/// As a frame of this precision holds it.
Vec3 in_precision(Vec3 position, Precision precision) {
    return {rounded_to(precision, position.x), rounded_to(precision, position.y), rounded_to(precision, position.z)};
}

/// True if after the second nothing is left of the first: particles that were shifted, or became fixed, stay so.
bool replaces(const SegmentBegin& later, const SegmentBegin& earlier) {
    if (later.description.alterations != earlier.description.alterations) return false;
    if (!later.act || !earlier.act) return !later.act && !earlier.act;
    const Pull* const pull = std::get_if<Pull>(&*later.act);
    return pull && pull->others.empty() && overwrites(*later.act, *earlier.act);
}

/// Distances of particles from where they are in the run.
class Distances {
public:
    void add(double distance) {
        largest_ = std::max(largest_, distance);
        squares_ += distance * distance;
        ++count_;
    }
    double largest() const { return largest_; }
    double root_mean_square() const { return count_ > 0 ? std::sqrt(squares_ / static_cast<double>(count_)) : 0; }

private:
    double largest_ = 0, squares_ = 0;
    std::size_t count_ = 0;
};

}  // namespace

LiveEnsemble::LiveEnsemble(std::size_t runs, Variation variation, const Execution& execution)
    : runs_(runs), variation_(std::move(variation)), execution_(execution) {}

bool LiveEnsemble::go_to(std::uint64_t step, std::span<const SegmentBegin> segments,
                         const std::function<bool()>& enough) {
    const FlushSubnormals flush;
    begin_last_again(segments);
    if (!are_in(segments) || step < segments_.back().step) {
        members_.clear();
        segments_.assign(1, segments.front());
    }
    if (members_.size() < runs_ && !begin(segments.front().description, enough)) return false;
    const bool next_is_behind = segments_.size() < segments.size() && segments[segments_.size()].step < step_;
    if (step_ > segments_.back().step && (step < step_ || next_is_behind)) {
        make_batches();
        step_ = segments_.back().step;
    }
    while (true) {
        const bool last = segments_.size() == segments.size() || segments[segments_.size()].step > step;
        const std::uint64_t end = last ? step : segments[segments_.size()].step;
        while (step_ < end) {
            if (enough()) return false;
            take(std::min(end - step_, steps_of_a_piece()));
        }
        if (last) return true;
        if (enough()) return false;
        go_on(segments[segments_.size()]);
    }
}

bool LiveEnsemble::are_at(std::uint64_t step, std::span<const SegmentBegin> segments) const {
    return members_.size() == runs_ && segments_.size() == segments.size() && step_ == step && are_in(segments);
}

/// True if these segments are the beginning of them.
bool LiveEnsemble::are_in(std::span<const SegmentBegin> segments) const {
    return !segments_.empty() && segments_.size() <= segments.size() &&
           std::equal(segments_.begin(), segments_.end(), segments.begin());
}

/// Where the last segment has become another that leaves nothing of it: a particle or a slider is dragged.
void LiveEnsemble::begin_last_again(std::span<const SegmentBegin> segments) {
    const std::size_t count = segments_.size();
    if (members_.size() < runs_ || count < 2 || count > segments.size()) return;
    const SegmentBegin &last = segments_.back(), &now = segments[count - 1];
    const bool rest_is_same = std::equal(segments_.begin(), std::prev(segments_.end()), segments.begin());
    if (!rest_is_same || last == now || last.step != now.step || !replaces(now, last)) return;
    make_batches();
    segments_.pop_back();
    go_on(now);
}

/// From the start of the run, or where `enough` had stopped this.
bool LiveEnsemble::begin(const RunDescription& description, const std::function<bool()>& enough) {
    const double particles = model_of(description).particles(description.scene);
    if (particles * static_cast<double>(runs_) > static_cast<double>(most_particles))
        throw UsageError(fmt::format("an ensemble of {} runs of {:.0f} particles is too large: at most {} in all",
                                     runs_, particles, most_particles));
    check_memory(description);
    batches_.clear();
    step_ = 0;
    for (std::size_t i = members_.size(); i < runs_; ++i) {
        if (enough()) return false;
        RunDescription held = as_held(variation_(description, i));
        Plan scene = plan_of(held);
        if (static_cast<double>(scene.reference.count) != particles)
            throw UsageError(fmt::format("run {} of the ensemble has {} particles, the run itself {:.0f}", i,
                                         scene.reference.count, particles));
        members_.push_back({std::move(held), std::move(scene)});
    }
    make_batches();
    return true;
}

void LiveEnsemble::check_memory(const RunDescription& description) const {
    const Plan scene = plan_of(description);
    const double one = static_cast<double>(scene.reference.count) * bytes_per_particle(description) +
                       bytes_of_interactions(description, scene);
    const double needed = static_cast<double>(runs_) * one, there = available_memory();
    if (needed <= there) return;
    throw UsageError(
        fmt::format("an ensemble of {} runs needs {} of memory, {} are available: choose {:.0f} runs at most", runs_,
                    bytes_text(needed), bytes_text(there), std::floor(there / one)));
}

/// Begins a segment as Simulation does: at the synchronised state.
void LiveEnsemble::go_on(const SegmentBegin& segment) {
    for (const Batch& batch : batches_) {
        for (std::size_t i = batch.first; i < batch.first + batch.count; ++i) continue_in(segment, i, batch);
    }
    make_batches();
    step_ = segment.step;
    segments_.push_back(segment);
}

void LiveEnsemble::continue_in(const SegmentBegin& segment, std::size_t i, const Batch& batch) {
    Member& member = members_[i];
    member.lost = !batch.finite(i);
    if (member.lost) return;
    State<double> state;
    batch.synchronised(i, state);
    if (segment.act) apply(*segment.act, member.scene.reference, state);
    const RunDescription before = std::move(member.held);
    member.held = as_held(variation_(segment.description, i));
    Plan scene = plan_of(member.held);
    if (before.alterations != member.held.alterations) carry_over(member.scene, scene, state);
    member.scene = std::move(scene);
    member.scene.start = Start(std::move(state));
}

/// Steppers of all of them, at the start of the segment.
void LiveEnsemble::make_batches() {
    batches_.clear();
    std::vector<StepperSetup> setups;
    for (const Member& it : members_) setups.push_back(segment_start(it.held, it.scene, instructions_of(execution_)));
    for (std::size_t first = 0; first < setups.size(); first += batches_.back().count)
        batches_.push_back(make_batch(std::span<const StepperSetup>(setups).subspan(first), first));
}

/// Of as many of the first ones as have room.
LiveEnsemble::Batch LiveEnsemble::make_batch(std::span<const StepperSetup> setups, std::size_t first) const {
    Batch batch;
    batch.first = first;
    std::size_t there = 0;
    while (there < setups.size() && !members_[first + there].lost) ++there;
    if (there == 0) return batch;
    const Method& how = method(members_[first].held.method);
    const auto together = lane_compatible_ones(setups.first(there));
    if (!together.empty() && how.runs_in_lanes(instructions_of(execution_)))
        batch.lanes = how.make_ensemble_stepper(together);
    if (batch.lanes) {
        batch.count = batch.lanes->runs();
    } else {
        batch.alone = how.make(setups.front());
    }
    return batch;
}

bool LiveEnsemble::Batch::finite(std::size_t member) const {
    if (lanes) return lanes->finite(member - first);
    return alone && alone->finite();
}

void LiveEnsemble::Batch::synchronised(std::size_t member, State<double>& out) const {
    if (lanes) {
        lanes->synchronised(member - first, out);
    } else {
        alone->synchronised(out);
    }
}

void LiveEnsemble::take(std::uint64_t steps) {
    for (Batch& batch : batches_) {
        if (batch.lanes) {
            batch.lanes->advance(steps);
        } else if (batch.alone) {
            batch.alone->advance(steps);
            if (!batch.alone->finite()) batch.alone.reset();
        }
    }
    step_ += steps;
}

std::uint64_t LiveEnsemble::steps_of_a_piece() const {
    const std::size_t particles = members_.empty() ? 0 : members_.front().scene.reference.count;
    return std::max<std::uint64_t>(1, steps_of_particles / std::max<std::size_t>(1, runs_ * particles));
}

std::size_t LiveEnsemble::in_lanes() const {
    return std::accumulate(batches_.begin(), batches_.end(), std::size_t{0},
                           [](std::size_t sum, const Batch& batch) { return sum + (batch.lanes ? batch.count : 0); });
}

EnsembleSpread LiveEnsemble::observe(Frame& run) {
    const FlushSubnormals flush;
    const std::size_t particles = run.positions.size();
    constexpr double nowhere = std::numeric_limits<double>::quiet_NaN();
    run.ensemble.assign(runs_ * particles, {nowhere, nowhere, nowhere});
    EnsembleSpread reading{.step = step_};
    Distances distances;
    for (const Batch& batch : batches_) {
        for (std::size_t i = batch.first; i < batch.first + batch.count; ++i) {
            if (!batch.finite(i)) {
                ++reading.lost;
                continue;
            }
            batch.synchronised(i, seen_);
            members_[i].scene.reference.each(0, particles, [&](std::size_t k, Vec3 reference) {
                const Vec3 place = in_precision(reference + seen_.displacement.at(k), run.precision);
                run.ensemble[i * particles + k] = place;
                distances.add(length(place - run.positions[k]));
            });
        }
    }
    reading.largest = distances.largest();
    reading.root_mean_square = distances.root_mean_square();
    return reading;
}

}  // namespace steplab
