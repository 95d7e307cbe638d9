#pragma once

#include "render/bounds.hpp"
#include "render/instances.hpp"
#include "render/shader_program.hpp"
#include "render/shot.hpp"

#include <optional>
#include <vector>

namespace steplab::render {

/// Draws the runs beside a run as an ensemble of faint dots, in the colours of its particles: what is inside these is
/// not seen, so that there is an ensemble only where the runs have parted.
class EnsembleDots {
public:
    EnsembleDots();

    void prepare(const Shot& shot);
    /// The box of all that can be drawn of it; none if there is nothing.
    const std::optional<Bounds>& bounds() const { return bounds_; }
    /// They are blended, so after everything solid.
    void draw(const ViewUniforms& view, double pixel_scale) const;

private:
    ShaderProgram program_;
    DotList dots_;
    std::vector<Dot> listed_;  ///< kept for its memory
    std::optional<Bounds> bounds_;
    float radius_ = 0;
};

}  // namespace steplab::render
