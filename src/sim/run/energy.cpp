#include "sim/run/energy.hpp"

#include "core/sum.hpp"
#include "models/potentials/list.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
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

double floor_of(const ComposedForces& forces) {
    double floor = std::numeric_limits<double>::min();
    for (const ComposedSpring& spring : forces.terms->springs) floor += spring_floor(spring.k, spring.length, 1);
    for (const ComposedPairs& pairs : forces.terms->pairs) {
        const PotentialInfo* const known = built_in_potential(pairs.potential);
        const bool has_depth = known && known->weight == PotentialInfo::Weight::none;
        const double depth = has_depth ? pairs.values.front() : 0;
        floor += depth * static_cast<double>(forces.count);
    }
    return floor;
}

/// Not in a box: where particles are moved in it, some come to lie on the images of others.
bool has_expressions_in_open_space(const Forces& forces) {
    const auto* const composed = std::get_if<ComposedForces>(&forces);
    if (!composed || !(composed->terms->box == Vec3{})) return false;
    const Composition& terms = *composed->terms;
    return !terms.fields.empty() || std::any_of(terms.pairs.begin(), terms.pairs.end(), [](const auto& pairs) {
        return built_in_potential(pairs.potential) == nullptr;
    });
}

/// Displacements of the particles from their reference positions when all are `factor` times as far from the origin as
/// they start, and `shift` times their largest distance from it beyond.
Field<double> elsewhere(const Plan& scene, double factor, double shift) {
    const std::size_t count = scene.reference.count;
    double farthest = 0;
    const auto each = [&](auto f) {
        scene.reference.each(0, count, [&](std::size_t i, Vec3 at) { f(i, at, at + scene.start[i].displacement); });
    };
    each([&](std::size_t, Vec3, Vec3 position) { farthest = std::max(farthest, length(position)); });
    const double way = shift * (farthest > 0 ? farthest : 1);
    Field<double> moved(count);
    each([&](std::size_t i, Vec3 at, Vec3 position) { moved.set(i, factor * position + Vec3{way, way, way} - at); });
    return moved;
}

/// Half the mass times the sum of the squared accelerations.
double outer_power_of(const ConstantForces& forces) {
    const double n = static_cast<double>(forces.count);
    return forces.mass / 2 * forces.step * forces.step * (n - 1) * n * (2 * n - 1) / 6;
}
double outer_power_of(const LineForces& forces) {
    return forces.mass / 2 * forces.gravity * forces.gravity * static_cast<double>(forces.count);
}
double outer_power_of(const ComposedForces& forces) {
    const Composition& terms = *forces.terms;
    const auto& all = terms.accelerations;
    double sum = 0;
    for (std::size_t i = 0; i < forces.count && !all.empty(); ++i) {
        const Vec3 a = all.size() == 1 ? all.front() : all[i];
        sum += (terms.masses.empty() ? 1 : terms.masses[i]) * dot(a, a);
    }
    return terms.mass / 2 * sum;
}
template <class NoOuterForces>
double outer_power_of(const NoOuterForces&) {
    return 0;
}

/// Particles of a piece, about: some of them are in the first-level cache.
constexpr std::size_t piece_length = 4096;

/// Particles that neighbouring pieces share; none where a scene is not taken in pieces.
std::size_t shared(const LineForces&) { return 1; }
std::size_t shared(const GridForces& forces) { return forces.columns; }
template <class Whole>
std::size_t shared(const Whole&) {
    return 0;
}

std::size_t shared(const Forces& forces) {
    return std::visit([](const auto& layout) { return shared(layout); }, forces);
}

Pieces pieces_of(const Plan& scene) {
    const std::size_t unit = shared(scene.forces), units = piece_length / std::max<std::size_t>(1, unit);
    return {scene.reference.count, std::max<std::size_t>(1, units) * std::max<std::size_t>(1, unit), unit};
}

}  // namespace

EnergyMeter::EnergyMeter(const Plan& scene, Instructions instructions)
    : energy_sums_(&energy_sums(instructions)),
      mass_(scene.mass),
      masses_(scene.masses),
      forces_(scene.forces),
      floor_(std::visit([](const auto& forces) { return floor_of(forces); }, forces_)),
      outer_power_(std::visit([](const auto& forces) { return outer_power_of(forces); }, forces_)),
      count_(scene.reference.count),
      unit_(shared(forces_)),
      pieces_(pieces_of(scene)),
      sums_(pieces_.count()) {
    if (has_expressions_in_open_space(forces_)) floor_ += floor_of_expressions(scene);
}

/// A typed potential may be 0 where the particles start, and says nothing of a size: what it is elsewhere does.
double EnergyMeter::floor_of_expressions(const Plan& scene) const {
    double floor = 0;
    for (const double part : {0.25, -0.25}) {
        const double there =
            energy_sums_->potential(forces_, elsewhere(scene, 1 + part, part), count_, count_).magnitude;
        if (std::isfinite(there)) floor = std::max(floor, there);
    }
    return floor;
}

Energy EnergyMeter::energy(std::size_t parts, const Emit& emit, const PieceSink& also) {
    if (unit_ == 0 && whole_.count() != count_) whole_ = Field<double>(count_);
    pieces_.each(parts, emit, [&](const Piece& piece) {
        sums_[piece.number] = sums_of(piece);
        if (also) also(piece);
    });
    return total();
}

double EnergyMeter::floor(double dt) const {
    const double outer = outer_power_ * dt * dt;
    return std::isfinite(outer) ? floor_ + outer : floor_;
}

double EnergyMeter::weighted(const Piece& piece) const {
    CompensatedSum sum;
    for (std::size_t i = 0; i < piece.own; ++i) {
        const Vec3 v = piece.state.velocity.at(i);
        sum.add(masses_[piece.first + i] * dot(v, v));
    }
    return sum.value();
}

EnergyMeter::Sums EnergyMeter::sums_of(const Piece& piece) {
    const Field<double>& u = piece.state.displacement;
    const double squares = masses_.empty() ? energy_sums_->squares(piece.state.velocity, piece.own) : weighted(piece);
    if (unit_ > 0) return {squares, energy_sums_->potential(forces_, u, piece.held, piece.own)};
    copy(u, 0, piece.own, whole_, piece.first);
    return {squares, {}};
}

Energy EnergyMeter::total() const {
    CompensatedSum squares, value, magnitude, external;
    for (const Sums& piece : sums_) {
        squares.add(piece.squares);
        value.add(piece.potential.value);
        magnitude.add(piece.potential.magnitude);
        external.add(piece.potential.external);
    }
    const double kinetic = mass_ / 2 * squares.value();
    if (unit_ == 0) return {kinetic, energy_sums_->potential(forces_, whole_, count_, count_)};
    return {kinetic, {value.value(), magnitude.value(), external.value()}};
}

}  // namespace steplab
