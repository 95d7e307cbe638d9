#pragma once

#include "core/frame.hpp"
#include "render/colouring.hpp"
#include "render/instances.hpp"
#include "render/shader_program.hpp"

namespace steplab::render {

/// Draws the springs of a frame as thin round rods, all in one draw.
class Springs {
public:
    Springs();
    /// Uploads the springs that the picture shows; those of neighbours only a few pixels apart are left out, as their
    /// particles already cover the picture there.
    void prepare(const Frame& frame, const Style& style, std::span<const Rgb> colours, const Projection& projection);
    void draw(const ViewUniforms& view, double pixel_scale) const;

private:
    ShaderProgram program_;
    float radius_ = 0;
    std::vector<Rod> rods_;  ///< kept for its memory
    RodList list_;
};

}  // namespace steplab::render
