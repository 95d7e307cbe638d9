#include "sim/run/measures.hpp"

#include <fmt/format.h>
#include <xxhash.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

namespace steplab {

void ParticleSums::add(const Piece& piece) {
    const Field<double>&u = piece.state.displacement, &velocity = piece.state.velocity;
    Sums sums;
    scene_.reference.each(piece.first, piece.own, [&](std::size_t i, Vec3 reference) {
        const Vec3 counted = u.at(i - piece.first), position = reference + counted, v = velocity.at(i - piece.first);
        const Vec3 displacement = position - shape_.rest[i];
        const Vec3 momentum = scene_.masses.empty() ? v : scene_.masses[i] * v;
        sums.velocity = sums.velocity + momentum;
        sums.turning = sums.turning + cross(position, momentum);
        sums.displacement_squared = std::max(sums.displacement_squared, dot(displacement, displacement));
        sums.farthest_squared = std::max(sums.farthest_squared, dot(counted, counted));
        sums.speed_squared = std::max(sums.speed_squared, dot(v, v));
    });
    pieces_[piece.number] = sums;
}

Diagnostics ParticleSums::result() const {
    Sums all;
    for (const Sums& piece : pieces_) {
        all.velocity = all.velocity + piece.velocity;
        all.turning = all.turning + piece.turning;
        all.displacement_squared = std::max(all.displacement_squared, piece.displacement_squared);
        all.farthest_squared = std::max(all.farthest_squared, piece.farthest_squared);
        all.speed_squared = std::max(all.speed_squared, piece.speed_squared);
    }
    Diagnostics diagnostics;
    diagnostics.momentum = scene_.mass * all.velocity;
    diagnostics.angular_momentum = scene_.mass * all.turning;
    diagnostics.max_displacement = std::sqrt(all.displacement_squared);
    diagnostics.farthest = std::sqrt(all.farthest_squared);
    diagnostics.max_speed = std::sqrt(all.speed_squared);
    return diagnostics;
}

double largest_error(const Field<double>& displacement, const ExactSolution& exact, double time) {
    std::vector<Vec3> right(displacement.count());
    exact.displacements(time, right);
    double largest = 0;
    for (std::size_t i = 0; i < right.size(); ++i) largest = std::max(largest, length(displacement.at(i) - right[i]));
    return largest;
}

namespace {

const double* component(const State<double>& state, std::size_t c) {
    const Field<double>& field = c < 3 ? state.displacement : state.velocity;
    return c % 3 == 0 ? field.x() : c % 3 == 1 ? field.y() : field.z();
}

/// Component after component of all particles, each hash the seed of the next: one pass for each of them, which takes
/// less than memory for all.
template <class T>
std::uint64_t hash_in(std::uint64_t step, const std::function<void(const PortionSink&)>& emit) {
    XXH64_hash_t hash = XXH64(&step, sizeof step, 0);
    const std::unique_ptr<XXH64_state_t, decltype(&XXH64_freeState)> stream(XXH64_createState(), &XXH64_freeState);
    std::vector<T> held;
    for (std::size_t c = 0; c < 6; ++c) {
        XXH64_reset(stream.get(), hash);
        emit([&](const Portion& portion) {
            const double* const numbers = component(portion.state, c) + portion.place;
            held.resize(portion.count);
            std::transform(numbers, numbers + portion.count, held.begin(),
                           [](double number) { return static_cast<T>(number); });
            XXH64_update(stream.get(), held.data(), held.size() * sizeof(T));
        });
        hash = XXH64_digest(stream.get());
    }
    return hash;
}

}  // namespace

double farthest_of(const std::function<void(const PortionSink&)>& emit) {
    double largest = 0;
    emit([&](const Portion& portion) {
        for (std::size_t i = portion.place; i < portion.place + portion.count; ++i) {
            const Vec3 counted = portion.state.displacement.at(i);
            largest = std::max(largest, dot(counted, counted));
        }
    });
    return std::sqrt(largest);
}

std::string hash_of(std::uint64_t step, Precision precision, const std::function<void(const PortionSink&)>& emit) {
    const std::uint64_t hash =
        precision == Precision::float_ ? hash_in<float>(step, emit) : hash_in<double>(step, emit);
    return fmt::format("{:016x}", hash);
}

}  // namespace steplab
