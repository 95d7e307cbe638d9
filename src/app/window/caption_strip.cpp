#include "app/window/caption_strip.hpp"

#include <imgui.h>

namespace steplab {

int CaptionStrip::lay_out(const SessionView& view, render::Style style, const ui::Display& above,
                          const ui::Caption& caption) {
    ui::Display display = above;
    if (!tools_) {
        tools_.emplace(display);
    } else if (tools_->interface.resize(display)) {
        tools_->renderer.upload_fonts(tools_->interface.fonts());
    }
    const int height = tools_->interface.caption_height(view, caption);
    display.height += height;
    tools_->interface.resize(display);
    render::Camera camera;
    tools_->interface.draw_still(view, {camera, style}, true, caption);
    return height;
}

void CaptionStrip::draw() const { tools_->renderer.draw(tools_->interface.draw_data()); }

}  // namespace steplab
