#pragma once

#include "render/font_files.hpp"
#include "ui/widgets/colours.hpp"

#include <imgui.h>

#include <optional>
#include <string>
#include <string_view>

namespace steplab::ui {

/// The fonts in the sizes that the interface uses; owned by the atlas of the ImGui context.
struct Fonts {
    ImFont* body = nullptr;
    ImFont* strong = nullptr;   ///< titles, chosen values
    ImFont* small = nullptr;    ///< explanations, axes
    ImFont* tiny = nullptr;     ///< footer of the panel
    ImFont* heading = nullptr;  ///< of a section
    std::string source;         ///< their file; "built in" if none was found
};

/// Sizes, colours and fonts at one scale of the display.
class Theme {
public:
    /// Sets the style of the current ImGui context and fills its font atlas.
    void apply(float scale);
    /// Sets the colours of the current ImGui context.
    void set_background(render::Background background);

    float scale() const { return scale_; }
    /// Pixels of a length in units of the layout, a whole number so that edges are sharp.
    float px(float units) const;
    const Fonts& fonts() const { return fonts_; }

private:
    float scale_ = 0;
    std::optional<render::Background> background_;  ///< none before set_background()
    Fonts fonts_;
};

/// Fills the atlas from these files, or with ImGui's own font if there are none. All digits have the same width, so
/// that changing numbers do not jitter.
Fonts load_fonts(ImFontAtlas& atlas, float scale, const render::FontFiles& files);

/// Uses a font until the end of the block.
class WithFont {
public:
    explicit WithFont(ImFont* font) { ImGui::PushFont(font); }
    ~WithFont() { ImGui::PopFont(); }
    WithFont(const WithFont&) = delete;
    WithFont& operator=(const WithFont&) = delete;
};

/// Scopes the names of widgets until the end of the block.
class WithId {
public:
    explicit WithId(std::string_view id) { ImGui::PushID(id.data(), id.data() + id.size()); }
    ~WithId() { ImGui::PopID(); }
    WithId(const WithId&) = delete;
    WithId& operator=(const WithId&) = delete;
};

}  // namespace steplab::ui
