#pragma once

#include "core/shape.hpp"
#include "render/camera.hpp"
#include "ui/context.hpp"

#include <cstddef>
#include <memory>
#include <optional>
#include <string>

namespace steplab::ui {

/// Keeps the camera and the followed particle suited to the scene: a new scene is shown whole, with one particle
/// followed. A camera that the user has moved stays until the model changes.
class ViewKeeper {
public:
    void keep(const Context& context);

private:
    std::string model_;
    std::shared_ptr<const Shape> shape_;
    PixelRect place_;
    std::optional<render::Camera> home_;  ///< where the camera was last placed by the program
};

}  // namespace steplab::ui
