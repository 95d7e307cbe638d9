#include "sim/measures.hpp"

#include <fmt/format.h>
#include <xxhash.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace steplab {

Diagnostics sums_over_particles(const State<double>& state, const Scene& scene, const Shape& shape) {
    Diagnostics sums;
    for (std::size_t i = 0; i < state.velocity.count(); ++i) {
        const Vec3 position = scene.reference.at(i) + state.displacement.at(i), v = state.velocity.at(i);
        const Vec3 displacement = position - shape.rest[i];
        sums.momentum = sums.momentum + v;
        sums.angular_momentum = sums.angular_momentum + cross(position, v);
        sums.max_displacement = std::max(sums.max_displacement, dot(displacement, displacement));
        sums.max_speed = std::max(sums.max_speed, dot(v, v));
    }
    sums.momentum = scene.mass * sums.momentum;
    sums.angular_momentum = scene.mass * sums.angular_momentum;
    sums.max_displacement = std::sqrt(sums.max_displacement);
    sums.max_speed = std::sqrt(sums.max_speed);
    return sums;
}

double largest_error(const Field<double>& displacement, const ExactSolution& exact, double time) {
    std::vector<Vec3> right(displacement.count());
    exact.displacements(time, right);
    double largest = 0;
    for (std::size_t i = 0; i < right.size(); ++i) largest = std::max(largest, length(displacement.at(i) - right[i]));
    return largest;
}

namespace {

template <class T>
std::uint64_t hash_in(std::uint64_t step, const State<double>& state) {
    XXH64_hash_t hash = XXH64(&step, sizeof step, 0);
    std::vector<T> held(state.velocity.count());
    for (const Field<double>* field : {&state.displacement, &state.velocity}) {
        for (const double* component : {field->x(), field->y(), field->z()}) {
            std::transform(component, component + held.size(), held.begin(),
                           [](double number) { return static_cast<T>(number); });
            hash = XXH64(held.data(), held.size() * sizeof(T), hash);
        }
    }
    return hash;
}

}  // namespace

std::string hash_of(std::uint64_t step, Precision precision, const State<double>& state) {
    const std::uint64_t hash =
        precision == Precision::float_ ? hash_in<float>(step, state) : hash_in<double>(step, state);
    return fmt::format("{:016x}", hash);
}

}  // namespace steplab
