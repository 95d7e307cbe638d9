// The strip with the caption below a picture of the window.
#pragma once

#include "render/imgui_renderer.hpp"
#include "ui/interface.hpp"

#include <optional>

namespace steplab {

/// Draws captions with an interface of its own, so that menus and entries of the window's are not disturbed.
class CaptionStrip {
public:
    /// Lays the caption out, for a picture of this size that stands above it. Its height in pixels.
    int lay_out(const SessionView& view, render::Style style, const ui::Display& above, const ui::Caption& caption);
    /// Draws it into the bound framebuffer, of which it is the foot.
    void draw() const;

private:
    struct Tools {
        explicit Tools(const ui::Display& display) : interface(display) { renderer.upload_fonts(interface.fonts()); }

        ui::Interface interface;
        render::ImguiRenderer renderer;
    };
    std::optional<Tools> tools_;  ///< made when first needed
};

}  // namespace steplab
