#pragma once

#include "core/shape.hpp"
#include "core/vec3.hpp"
#include "render/following.hpp"
#include "ui/context.hpp"

#include <cstdint>
#include <memory>
#include <optional>

namespace steplab::ui {

/// Moves the camera by as much as the point that it follows has moved. Between, the user turns and moves it as always.
class Follower {
public:
    void follow(const Context& context);

private:
    /// A point of another kind, particle or run is no way to go.
    struct Kind {
        render::Following following = render::Following::nothing;
        std::optional<std::size_t> selected;
        std::uint64_t run = 0;
        std::shared_ptr<const Shape> shape;
        bool operator==(const Kind&) const = default;
    };
    Kind kind_;
    std::uint64_t step_ = 0;
    std::optional<Vec3> last_;
};

}  // namespace steplab::ui
