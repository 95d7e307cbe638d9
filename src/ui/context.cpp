#include "ui/context.hpp"

#include "render/split.hpp"

#include <filesystem>
#include <system_error>

namespace steplab::ui {

Notice notice_of_saved(const std::string& file) {
    constexpr double seconds = 8;  // to read a path and to reach it with the pointer
    std::error_code none;          // a folder that is gone has no path
    const std::filesystem::path path = std::filesystem::absolute(file, none);
    const std::string shown = none ? file : path.string();
    return {"saved " + shown, ImGui::GetTime() + seconds, shown};
}

const render::DrawnSizes& Context::sizes() const {
    if (!state.shape || state.shape->shape != view.frame.shape) state.shape.emplace(view.frame.shape);
    return state.shape->sizes;
}

std::vector<PixelRect> Context::tiles() const {
    const PixelRect scene = pixels(layout.scene);
    std::vector<PixelRect> tiles;
    for (const auto& [left, top, size] :
         render::areas_of({scene.width, scene.height}, stage.style.layout, 1 + session.followers.size()))
        tiles.push_back({scene.x + left, scene.y + top, size.width, size.height});
    return tiles;
}

render::Projection Context::projection() const {
    const PixelRect rect = tile();
    return {stage.camera, {rect.width, rect.height}};
}

void Context::mark(std::string_view widget) const {
    const ImVec2 from = ImGui::GetItemRectMin();
    const ImVec2 to = ImGui::GetItemRectMax();
    mark(widget, {from.x, from.y, to.x, to.y});
    note_focus(widget);
}

void Context::note_focus(std::string_view widget) const {
    if (state.steering && ImGui::IsItemFocused()) state.focused = widget;
}

void Context::mark(std::string_view widget, const WidgetRect& place) const {
    widgets.insert_or_assign(std::string(widget), place);
}

}  // namespace steplab::ui
