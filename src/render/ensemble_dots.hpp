#pragma once

#include "render/bounds.hpp"
#include "render/instances.hpp"
#include "render/shader_program.hpp"
#include "render/shot.hpp"

#include <optional>
#include <vector>

namespace steplab::render {

/// Draws the particles of an ensemble as faint dots in the colours of the particles of the run. Dots inside these are
/// hidden, so that they show only where the runs have diverged from each other.
class EnsembleDots {
public:
    EnsembleDots();

    void prepare(const Shot& shot);
    /// The box around all dots that can be drawn; none if there are none.
    const std::optional<Bounds>& bounds() const { return bounds_; }
    /// Blended, so to be drawn after everything opaque.
    void draw(const ViewUniforms& view, double pixel_scale) const;

private:
    ShaderProgram program_;
    DotList dots_;
    std::vector<Dot> listed_;  ///< kept to reuse its memory
    std::optional<Bounds> bounds_;
    float radius_ = 0;
};

}  // namespace steplab::render
