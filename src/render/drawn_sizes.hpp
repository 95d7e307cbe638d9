#pragma once

#include "core/shape.hpp"
#include "render/bounds.hpp"

namespace steplab::render {

/// The sizes at which particles and springs are drawn, in lengths of the scene: proportional to the spacing of
/// neighbours, but not too small to be seen in a wide scene.
class DrawnSizes {
public:
    explicit DrawnSizes(const Shape& shape);
    /// For a scene with these expected_bounds() and spacing of neighbours.
    DrawnSizes(const Bounds& expected, double spacing);
    /// Radius of a particle: of its ball, or of the ball around its cube or octahedron.
    double radius(Role role) const;
    double spring_radius() const { return 0.1 * ball_; }

private:
    double ball_;
};

}  // namespace steplab::render
