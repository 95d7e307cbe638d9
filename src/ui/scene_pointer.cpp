#include "ui/scene_pointer.hpp"

#include "render/framing.hpp"
#include "ui/hands.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <vector>

namespace steplab::ui {
namespace {

/// The pointer in the picture of a run: in one of several tiles, or beyond the only one.
struct Pointer {
    std::size_t run = 0;
    render::PixelPoint place;
};

Pointer pointer(const Context& context) {
    const auto x = static_cast<double>(ImGui::GetIO().MousePos.x), y = static_cast<double>(ImGui::GetIO().MousePos.y);
    const std::vector<PixelRect> tiles = context.tiles();
    const auto is_here = [&](const PixelRect& tile) {
        return x >= tile.x && x < tile.x + tile.width && y >= tile.y && y < tile.y + tile.height;
    };
    const auto found = std::find_if(tiles.begin(), tiles.end(), is_here);
    const auto run = found != tiles.end() ? static_cast<std::size_t>(found - tiles.begin()) : 0;
    return {run, {x - tiles[run].x, y - tiles[run].y}};
}

void drag(const Context& context, const render::Projection& projection) {
    const ImGuiIO& io = ImGui::GetIO();
    const double dx = static_cast<double>(io.MouseDelta.x);
    const double dy = static_cast<double>(io.MouseDelta.y);
    if (dx == 0 && dy == 0) return;
    const bool pan = io.MouseDown[1] || io.KeyShift;
    // A click may move the pointer by a few pixels: they do not count as a drag.
    const float tolerance = context.px(4);
    if (io.MouseDragMaxDistanceSqr[pan && io.MouseDown[1] ? 1 : 0] < tolerance * tolerance) return;
    context.state.dragged = true;
    context.stage.camera = pan ? render::panned(projection, dx, dy) : render::orbited(projection, dx, dy);
}

void zoom(const Context& context, const render::Projection& projection) {
    const double factor = std::pow(1.15, static_cast<double>(ImGui::GetIO().MouseWheel));
    context.stage.camera =
        render::zoomed(projection, factor, pointer(context).place, render::zoom_limits(context.view.frame));
}

/// A button was pressed over the scene: a gesture, a drag or a click begins.
void begin(const Context& context, const render::Projection& projection) {
    InterfaceState& state = context.state;
    state.drag_from_scene = !begin_gesture(context, projection);
    state.dragged = false;
}

/// Shows what a click would select; searched for less often than drawn where that would slow the pictures down.
void point_at(const Context& context, bool over) {
    InterfaceState& state = context.state;
    if (!over) return state.pointed.reset();
    const auto begin = std::chrono::steady_clock::now();
    if (!state.pointing.due(begin)) return;
    state.pointed = particle_under_pointer(context, context.projection());
    state.pointing.took(begin, std::chrono::steady_clock::now());
}

}  // namespace

void use_pointer(const Context& context) {
    const ImGuiIO& io = ImGui::GetIO();
    InterfaceState& state = context.state;
    const Area& scene = context.layout.scene;
    const render::Projection projection = context.projection();
    const bool over = !io.WantCaptureMouse && scene.contains(io.MousePos.x, io.MousePos.y);
    if (over && (io.MouseClicked[0] || io.MouseClicked[1])) begin(context, projection);
    use_hands(context, projection);
    if (state.drag_from_scene && (io.MouseDown[0] || io.MouseDown[1])) drag(context, projection);
    if (state.drag_from_scene && io.MouseReleased[0] && !state.dragged) click_particle(context, projection);
    if (!io.MouseDown[0] && !io.MouseDown[1]) state.drag_from_scene = false;
    if (over && io.MouseWheel != 0) zoom(context, projection);
    const bool dragging = (state.drag_from_scene && state.dragged) || state.hands.box_from || state.hands.kicked;
    point_at(context, over && !dragging);
}

}  // namespace steplab::ui
