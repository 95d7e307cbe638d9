#include "models/scene/random_start.hpp"

#include <cmath>

namespace steplab {

namespace {

/// The n-th random number of a seed, uniform in [0, 1): a counter, mixed as in SplitMix64 (Steele, Lea, Flood, OOPSLA
/// 2014).
double uniform(std::uint64_t seed, std::uint64_t n) {
    std::uint64_t z = (seed << 40) + (n + 1) * 0x9E3779B97F4A7C15;
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EB;
    return static_cast<double>((z ^ (z >> 31)) >> 11) * 0x1p-53;
}

/// A nearly normal random number of mean 0 and variance 1: the sum of twelve uniform ones, minus 6.
double nearly_normal(std::uint64_t seed, std::uint64_t n) {
    double sum = -6;
    for (std::uint64_t k = 0; k < 12; ++k) sum += uniform(seed, 12 * n + k);
    return sum;
}

/// Smaller indices are used for velocities.
constexpr std::uint64_t first_of_displacements = std::uint64_t(1) << 62;

}  // namespace

Vec3 random_displacement(const RandomDisplacement& random, std::size_t i) {
    const auto along = [&](std::uint64_t axis) {
        return random.width.value * (2 * uniform(random.seed, first_of_displacements + 3 * i + axis) - 1);
    };
    return {along(0), along(1), along(2)};
}

ThermalVelocities::ThermalVelocities(const Temperature& temperature, double mass, std::size_t count)
    : speed_(std::sqrt(temperature.kT.value / mass)), seed_(temperature.seed) {
    Vec3 sum;
    for (std::size_t i = 0; i < count; ++i) sum = sum + drawn(i);
    mean_ = 1 / static_cast<double>(count) * sum;
    if (temperature.exact) scale_ = exact_scale(temperature, mass, count);
}

Vec3 ThermalVelocities::drawn(std::size_t i) const {
    const auto along = [&](std::uint64_t axis) { return speed_ * nearly_normal(seed_, 3 * i + axis); };
    return {along(0), along(1), along(2)};
}

double ThermalVelocities::exact_scale(const Temperature& temperature, double mass, std::size_t count) const {
    double squares = 0;
    for (std::size_t i = 0; i < count; ++i) squares += dot((*this)[i], (*this)[i]);
    if (!(squares > 0)) return 0;
    const double degrees_of_freedom = 3 * static_cast<double>(count) - 3;
    return std::sqrt(degrees_of_freedom * temperature.kT.value / (mass * squares));
}

}  // namespace steplab
