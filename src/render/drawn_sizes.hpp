#pragma once

#include "core/shape.hpp"
#include "render/bounds.hpp"

namespace steplab::render {

/// How large the things of a scene are drawn, in its lengths: by the distance of neighbours, but not so small that they
/// would be lost in a wide scene.
class DrawnSizes {
public:
    explicit DrawnSizes(const Shape& shape);
    /// Of a scene with these expected_bounds() and distance of neighbours.
    DrawnSizes(const Bounds& expected, double spacing);
    /// Of a particle: of the ball, or of the ball around the body that it is drawn as.
    double radius(Role role) const;
    double spring_radius() const { return 0.1 * ball_; }

private:
    double ball_;
};

}  // namespace steplab::render
