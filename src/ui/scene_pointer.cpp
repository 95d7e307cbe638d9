#include "ui/scene_pointer.hpp"

#include "render/bounds.hpp"
#include "render/framing.hpp"
#include "render/picking.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <optional>
#include <vector>

namespace steplab::ui {
namespace {

bool went_down(int button) { return ImGui::GetIO().MouseClicked[button]; }

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

/// The position of the pointer in the picture of the leading run.
render::PixelPoint pointer_in_leading(const Context& context) {
    const ImVec2 pointer = ImGui::GetIO().MousePos;
    const PixelRect tile = context.tile();
    return {static_cast<double>(pointer.x) - tile.x, static_cast<double>(pointer.y) - tile.y};
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

std::optional<std::size_t> particle_under_pointer(const Context& context, const render::Projection& projection) {
    const Pointer here = pointer(context);
    if (here.run != 0) return std::nullopt;  // particles of other runs are not the ones that are picked
    return render::particle_at(context.view.frame, context.sizes(), projection, here.place,
                               static_cast<double>(context.px(10)));
}

/// Selects the particle under the pointer, if there is one.
std::optional<std::size_t> select(const Context& context, const render::Projection& projection) {
    const auto particle = particle_under_pointer(context, projection);
    if (particle) context.events.send(event::Track{particle});
    return particle;
}

void zoom(const Context& context, const render::Projection& projection) {
    const double factor = std::pow(1.15, static_cast<double>(ImGui::GetIO().MouseWheel));
    context.stage.camera =
        render::zoomed(projection, factor, pointer(context).place, render::zoom_limits(context.view.frame));
}

/// The point under the pointer in the plane through `place` that faces the eye.
Vec3 under_pointer_beside(Vec3 place, const Context& context, const render::Projection& projection) {
    const render::Ray ray = projection.ray(pointer_in_leading(context));
    const Vec3 forward = projection.forward();
    return ray.origin + (dot(place - ray.origin, forward) / dot(ray.direction, forward)) * ray.direction;
}

void pull(const Context& context, const render::Projection& projection) {
    const ImGuiIO& io = ImGui::GetIO();
    auto& pulled = context.state.pulled;
    if (!io.MouseDown[0] || *pulled >= context.view.frame.positions.size()) {
        pulled.reset();
    } else if (io.MouseDelta.x != 0 || io.MouseDelta.y != 0) {
        const Vec3 seen = context.view.frame.seen(*pulled);
        if (!render::drawable(seen)) return;
        context.events.send(event::Do{Pull{*pulled, under_pointer_beside(seen, context, projection)}});
        context.state.pulled_in = context.view.run;
    }
}

/// A button was pressed over the scene: a pull, a drag or a click begins.
void begin(const Context& context, const render::Projection& projection) {
    InterfaceState& state = context.state;
    const ImGuiIO& io = ImGui::GetIO();
    if (went_down(0) && io.KeyCtrl) state.pulled = select(context, projection);
    state.drag_from_scene = !(went_down(0) && io.KeyCtrl);
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
    if (over && (went_down(0) || went_down(1))) begin(context, projection);
    if (state.pulled) pull(context, projection);
    if (state.drag_from_scene && (io.MouseDown[0] || io.MouseDown[1])) drag(context, projection);
    if (state.drag_from_scene && io.MouseReleased[0] && !state.dragged) select(context, projection);
    if (!io.MouseDown[0] && !io.MouseDown[1]) state.drag_from_scene = false;
    if (over && io.MouseWheel != 0) zoom(context, projection);
    const bool dragging = state.drag_from_scene && state.dragged;
    point_at(context, over && !dragging);
}

}  // namespace steplab::ui
