#pragma once

#include "render/font_files.hpp"

#include <imgui.h>

#include <string>
#include <string_view>

namespace steplab::ui {

/// The colours of the interface.
namespace colour {
inline constexpr ImU32 rgb(unsigned hex, unsigned alpha = 255) {
    return IM_COL32((hex >> 16) & 0xff, (hex >> 8) & 0xff, hex & 0xff, alpha);
}
inline constexpr ImU32 panel = rgb(0x1c2128);      ///< side panel, bars, plots
inline constexpr ImU32 backdrop = rgb(0x12151a);   ///< behind the panels
inline constexpr ImU32 card = rgb(0x15181e, 235);  ///< over the scene
inline constexpr ImU32 line = rgb(0x2a313b);       ///< borders, separators, grid lines of plots
inline constexpr ImU32 control = rgb(0x262d36);    ///< buttons, combos, entries
inline constexpr ImU32 control_hover = rgb(0x303944);
inline constexpr ImU32 control_active = rgb(0x3a4553);
inline constexpr ImU32 track = rgb(0x323a45);  ///< of a slider
inline constexpr ImU32 knob = rgb(0xd7dde5);
inline constexpr ImU32 text = rgb(0xd7dde5);
inline constexpr ImU32 text_dim = rgb(0x98a2b0);
inline constexpr ImU32 text_faint = rgb(0x6b7684);
inline constexpr ImU32 accent = rgb(0x4ea1ff);
inline constexpr ImU32 accent_hover = rgb(0x6cb2ff);
inline constexpr ImU32 on_accent = rgb(0xffffff);
inline constexpr ImU32 good = rgb(0x3fb37f);
inline constexpr ImU32 caution = rgb(0xe0a33e);  ///< works, but not well
inline constexpr ImU32 bad = rgb(0xe06c6c);
inline constexpr ImU32 exact = rgb(0xe8b866);  ///< the exact solution in plots
}  // namespace colour

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

    float scale() const { return scale_; }
    /// Pixels of a length in units of the layout, a whole number so that edges are sharp.
    float px(float units) const;
    const Fonts& fonts() const { return fonts_; }

private:
    float scale_ = 0;
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
