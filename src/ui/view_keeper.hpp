#pragma once

#include "core/shape.hpp"
#include "render/camera.hpp"
#include "ui/context.hpp"

#include <cstddef>
#include <memory>
#include <optional>
#include <string>

namespace steplab::ui {

/// Sees to it that a new scene is whole in the picture and one of its particles is followed. A camera that the person
/// has moved stays where it is until another model comes.
class ViewKeeper {
public:
    void keep(const Context& context);

private:
    std::string model_;
    std::shared_ptr<const Shape> shape_;
    PixelRect place_;
    std::optional<render::Camera> home_;  ///< where the camera was put last
};

}  // namespace steplab::ui
