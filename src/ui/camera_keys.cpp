#include "ui/camera_keys.hpp"

#include "render/framing.hpp"
#include "ui/input.hpp"

#include <cmath>

namespace steplab::ui {
namespace {

/// A key is a drag of the pointer by so many units of the layout, or a step of the wheel.
constexpr float key_drag = 30;
constexpr double key_zoom = 1.15;

}  // namespace

bool use_camera_keys(const Context& context) {
    const ImGuiIO& io = ImGui::GetIO();
    if (!io.KeyAlt || io.KeyCtrl || io.WantTextInput || context.state.steering || context.state.scenes.open)
        return io.KeyAlt && !io.KeyCtrl;
    const render::Projection projection = context.projection();
    const double dx = static_cast<double>(context.px(key_drag)) * presses(Key::right, Key::left);
    const double dy = static_cast<double>(context.px(key_drag)) * presses(Key::down, Key::up);
    const int closer = presses(Key::equal, Key::minus);
    const auto [width, height] = projection.size();
    const render::PixelPoint middle{0.5 * width, 0.5 * height};
    render::Camera& camera = context.stage.camera;
    if (dx != 0 || dy != 0)
        camera = io.KeyShift ? render::panned(projection, dx, dy) : render::orbited(projection, dx, dy);
    if (closer != 0)
        camera =
            render::zoomed(projection, std::pow(key_zoom, closer), middle, render::zoom_limits(context.view.frame));
    return true;
}

}  // namespace steplab::ui
