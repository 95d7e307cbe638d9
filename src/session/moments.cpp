#include "session/moments.hpp"

#include <algorithm>
#include <iterator>
#include <numeric>
#include <tuple>
#include <utility>

namespace steplab {

namespace {

/// Moments kept at most, so that thinning out stays a matter of microseconds.
constexpr std::size_t most_moments = 4096;

std::size_t bytes_of(const std::vector<Moments::Moment>& moments) {
    return std::accumulate(moments.begin(), moments.end(), std::size_t{0},
                           [](std::size_t sum, const auto& moment) { return sum + moment.state.bytes(); });
}

/// The first of them that lies after this place.
template <class Moments>
auto after(Moments& moments, std::uint64_t step, std::size_t changes) {
    return std::find_if(moments.begin(), moments.end(), [&](const auto& moment) {
        return std::tie(moment.changes, moment.step) > std::tie(changes, step);
    });
}

}  // namespace

void Moments::allow(std::size_t bytes) {
    allowed_ = bytes;
    keep_to_memory();
}

void Moments::offer(const Simulation& simulation, std::size_t changes, std::size_t since) {
    keep_within(simulation, {simulation.step(), changes, since, {}}, spacing_);
}

void Moments::keep(const Simulation& simulation, std::size_t changes, std::size_t since) {
    keep_within(simulation, {simulation.step(), changes, since, {}}, 1);
}

/// Unless one lies so few steps before.
void Moments::keep_within(const Simulation& simulation, const Moment& moment, std::uint64_t spacing) {
    const auto place = after(moments_, moment.step, moment.changes);
    if (place != moments_.begin()) {
        const Moment& last = *std::prev(place);
        if (last.since == moment.since && moment.step < last.step + spacing) return;
    }
    if (!simulation.is_plausible()) return;
    const auto added = moments_.insert(place, moment);
    added->state = simulation.save();
    used_ += added->state.bytes();
    keep_to_memory();
}

const Moments::Moment* Moments::before(std::uint64_t step, std::size_t changes) const {
    const Moment* last = nullptr;
    for (const Moment& moment : moments_) {
        if (moment.step <= step && moment.changes <= changes) last = &moment;
    }
    return last;
}

std::vector<Moments::Moment> Moments::cut(std::uint64_t step, std::size_t changes) {
    const auto first = std::find_if(moments_.begin(), moments_.end(), [&](const Moment& moment) {
        return moment.changes > changes || moment.step > step;
    });
    std::vector<Moment> removed(std::make_move_iterator(first), std::make_move_iterator(moments_.end()));
    moments_.erase(first, moments_.end());
    used_ -= bytes_of(removed);
    return removed;
}

void Moments::append(std::vector<Moment> moments) {
    used_ += bytes_of(moments);
    std::move(moments.begin(), moments.end(), std::back_inserter(moments_));
    keep_to_memory();
}

void Moments::clear() {
    moments_.clear();
    used_ = 0;
    spacing_ = 16;
}

void Moments::keep_to_memory() {
    if (used_ > allowed_ || moments_.size() > most_moments) thin_out();
    while (used_ > allowed_ && moments_.size() > 2) {
        used_ -= moments_.front().state.bytes();
        moments_.erase(moments_.begin());
    }
}

/// Doubles the spacing and keeps every other moment, the first after each change and the last always.
void Moments::thin_out() {
    spacing_ *= 2;
    std::vector<Moment> kept;
    for (Moment& moment : moments_) {
        const bool first = kept.empty() || kept.back().since != moment.since;
        if (first || moment.step >= kept.back().step + spacing_ || &moment == &moments_.back())
            kept.push_back(std::move(moment));
    }
    moments_ = std::move(kept);
    used_ = bytes_of(moments_);
}

}  // namespace steplab
