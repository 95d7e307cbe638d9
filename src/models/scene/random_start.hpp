#pragma once

#include "core/vec3.hpp"
#include "models/scene/scene.hpp"

#include <cstddef>
#include <cstdint>

namespace steplab {

/// A displacement uniform within +-width along each axis, by seed and index.
Vec3 random_displacement(const RandomDisplacement& random, std::size_t i);

/// The thermal velocities of a block of particles of one mass: their mean is zero.
class ThermalVelocities {
public:
    ThermalVelocities(const Temperature& temperature, double mass, std::size_t count);
    Vec3 operator[](std::size_t i) const { return scale_ * (drawn(i) - mean_); }

private:
    Vec3 drawn(std::size_t i) const;
    /// So that sum m v^2 = (3 n - 3) kT.
    double exact_scale(const Temperature& temperature, double mass, std::size_t count) const;

    double speed_;
    std::uint64_t seed_;
    Vec3 mean_{};
    double scale_ = 1;
};

}  // namespace steplab
