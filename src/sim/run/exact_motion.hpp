#pragma once

#include "models/model.hpp"

#include <cstddef>
#include <memory>
#include <optional>

namespace steplab {

/// The motion of one particle in closed form.
struct ExactMotion {
    std::shared_ptr<const ExactSolution> solution;  ///< never null
    std::size_t particle = 0;
    Vec3 origin;  ///< of the displacements of the solution, from the particle's place in shape()->rest [m]

    /// From that place [m]; none at a time for which the solution is not valid.
    std::optional<Vec3> displacement(double time) const {
        if (time > solution->valid_until()) return std::nullopt;
        return origin + solution->displacement(particle, time);
    }
    /// [m/s], at such a time.
    Vec3 velocity(double time) const { return solution->velocity(particle, time); }

    friend bool operator==(const ExactMotion&, const ExactMotion&) = default;
};

}  // namespace steplab
