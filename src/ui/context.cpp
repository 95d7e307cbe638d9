#include "ui/context.hpp"

namespace steplab::ui {

void Context::mark(std::string_view widget) const {
    const ImVec2 from = ImGui::GetItemRectMin();
    const ImVec2 to = ImGui::GetItemRectMax();
    mark(widget, {from.x, from.y, to.x, to.y});
}

void Context::mark(std::string_view widget, const WidgetRect& place) const {
    widgets.insert_or_assign(std::string(widget), place);
}

}  // namespace steplab::ui
