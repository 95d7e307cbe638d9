#include "ui/panels/panels.hpp"

#include <algorithm>

namespace steplab::ui {

void draw_pointed(const Context& context) {
    const std::optional<std::size_t> particle =
        context.state.hands.pulled ? context.state.hands.pulled : context.state.pointed;
    const Frame& frame = context.pictured.leading.frame;
    if (context.purpose != Purpose::use || !particle || *particle >= frame.positions.size()) return;
    const Area& scene = context.layout.scene;
    const render::Projection projection = context.projection();
    const Vec3 place = frame.seen(*particle);
    if (!render::drawable(place)) return;
    const auto pixel = projection.pixel(place);
    if (!pixel) return;
    const double radius = context.sizes().radius(frame.shape->roles[*particle]);
    const double drawn = radius * projection.pixels_per_unit(projection.depth(place));
    const double largest = std::max(scene.width, scene.height);
    const float ring = static_cast<float>(std::min(drawn, largest)) + context.px(4);
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    list.PushClipRect({scene.x, scene.y}, {scene.right(), scene.bottom()});
    list.AddCircle({scene.x + static_cast<float>(pixel->x), scene.y + static_cast<float>(pixel->y)}, ring,
                   colour::accent, 0, context.px(2));
    list.PopClipRect();
}

}  // namespace steplab::ui
