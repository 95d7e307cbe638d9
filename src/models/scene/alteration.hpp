#pragma once

#include "models/model.hpp"
#include "models/scene/scene.hpp"

#include <cstddef>
#include <optional>
#include <span>

namespace steplab {

/// What was made of a particle of a scene, in place of what the scene says.
struct Alteration {
    std::size_t particle = 0;
    std::optional<bool> fixed = {};
    std::optional<double> mass = {};  ///< > 0 [kg]
    friend bool operator==(const Alteration&, const Alteration&) = default;
};

/// The scene with these alterations, in ascending order of particles.
Scene altered(Scene scene, std::span<const Alteration> alterations);

/// The shape of such a scene, from that without alterations.
Shape altered(Shape shape, const Scene& scene);

}  // namespace steplab
