#include "sim/energy.hpp"

#include <algorithm>
#include <limits>
#include <utility>
#include <variant>

namespace steplab {

namespace {

/// Springs at rest hold rounding errors of this part of the energy it takes to press one of them to nothing.
constexpr double spring_rounding = 1e-12;

double spring_floor(double k, double length, std::size_t springs) {
    const double least = std::numeric_limits<double>::min();
    return spring_rounding * 0.5 * k * length * length * static_cast<double>(springs) + least;
}

double floor_of(const ConstantForces& forces) { return spring_floor(forces.mass * forces.step, 1, forces.count); }
double floor_of(const LineForces& forces) { return spring_floor(forces.k, forces.rest_length, forces.count); }
double floor_of(const GridForces& forces) {
    return spring_floor(forces.k, forces.rest_length, 4 * forces.rows * forces.columns);
}
double floor_of(const PairForces& forces) { return forces.depth * static_cast<double>(forces.count); }

/// Particles of a piece, about: some of them are in the first-level cache.
constexpr std::size_t piece_length = 4096;

/// Particles that neighbouring pieces share; none where a scene is not taken in pieces.
std::size_t shared(const LineForces&) { return 1; }
std::size_t shared(const GridForces& forces) { return forces.columns; }
template <class Whole>
std::size_t shared(const Whole&) {
    return 0;
}

/// Copies particles to another place.
void copy(const Field<double>& from, std::size_t first, std::size_t count, Field<double>& to, std::size_t place) {
    std::copy_n(from.x() + first, count, to.x() + place);
    std::copy_n(from.y() + first, count, to.y() + place);
    std::copy_n(from.z() + first, count, to.z() + place);
}

}  // namespace

void SquareSum::add(const Field<double>& from, std::size_t first, std::size_t count) {
    while (count > 0) {
        const std::size_t more = std::min(count, held_.count() - count_);
        copy(from, first, more, held_, count_);
        count_ += more, first += more, count -= more;
        if (count_ == held_.count()) finish_piece();
    }
}

double SquareSum::take() {
    finish_piece();
    return std::exchange(sum_, {}).value();
}

void SquareSum::finish_piece() {
    sum_.add(sums_->squares(held_, count_));
    count_ = 0;
}

EnergyMeter::EnergyMeter(const Scene& scene, Instructions instructions)
    : sums_(&energy_sums(instructions)),
      mass_(scene.mass),
      forces_(scene.forces),
      floor_(std::visit([](const auto& forces) { return floor_of(forces); }, forces_)),
      count_(scene.reference.count),
      unit_(std::visit([](const auto& forces) { return shared(forces); }, forces_)),
      length_(unit_ > 0 ? std::max<std::size_t>(1, piece_length / unit_) * unit_ : count_),
      squares_(*sums_, std::min(count_, piece_length)) {}

void EnergyMeter::begin() {
    const std::size_t capacity = std::min(count_, length_ + unit_);
    if (piece_.count() != capacity) piece_ = Field<double>(capacity);
    held_ = taken_ = 0;
    squares_.take();
    value_ = magnitude_ = external_ = {};
}

Energy EnergyMeter::energy(const std::function<void(const PortionSink&)>& look) {
    begin();
    look([this](const Portion& portion) { add(portion); });
    return {mass_ / 2 * squares_.take(), {value_.value(), magnitude_.value(), external_.value()}};
}

void EnergyMeter::add(const Portion& portion) {
    squares_.add(portion.state.velocity, portion.place, portion.count);
    for (std::size_t from = 0; from < portion.count;) {
        const std::size_t more = std::min(portion.count - from, piece_.count() - held_);
        copy(portion.state.displacement, portion.place + from, more, piece_, held_);
        held_ += more, from += more, taken_ += more;
        if (held_ == piece_.count() || taken_ == count_) finish_piece();
    }
}

void EnergyMeter::finish_piece() {
    const bool last = taken_ == count_;
    const std::size_t own = last ? held_ : length_;
    const auto potential = sums_->potential(forces_, piece_, held_, own);
    value_.add(potential.value), magnitude_.add(potential.magnitude), external_.add(potential.external);
    held_ -= own;
    copy(piece_, own, held_, piece_, 0);
}

}  // namespace steplab
