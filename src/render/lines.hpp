#pragma once

#include "render/instances.hpp"
#include "render/shader_program.hpp"

#include <span>

namespace steplab::render {

/// Draws plain lines in space, of the same width everywhere. Alpha mixes their colour with the background.
class Lines {
public:
    Lines();
    /// `width` in pixels.
    void draw(std::span<const Rod> lines, const ViewUniforms& view, double width);

private:
    ShaderProgram program_;
    RodList list_;
};

}  // namespace steplab::render
