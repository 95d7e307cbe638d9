#include "ui/widgets/theme.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace steplab::ui {
namespace {

// European Latin, Greek, superscripts and subscripts, punctuation, arrows, mathematics and simple shapes.
constexpr std::array<ImWchar, 21> letters = {0x0020, 0x002f, 0x003a, 0x017f, 0x0370, 0x03ff, 0x2010,
                                             0x2027, 0x2032, 0x2033, 0x2070, 0x209f, 0x2190, 0x21ff,
                                             0x2200, 0x22ff, 0x25a0, 0x25ff, 0x2713, 0x2713, 0};
constexpr std::array<ImWchar, 3> digits = {'0', '9', 0};

/// Width of the widest digit at this size, measured in a separate atlas.
float digit_width(const std::string& file, float size) {
    ImFontAtlas scratch;
    const ImFont* font = scratch.AddFontFromFileTTF(file.c_str(), size, nullptr, digits.data());
    scratch.Build();
    float width = 0;
    for (ImWchar digit = '0'; digit <= '9'; ++digit) width = std::max(width, font->FindGlyph(digit)->AdvanceX);
    return width;
}

ImFont* add_font(ImFontAtlas& atlas, const std::string& file, float size) {
    if (file.empty()) {
        ImFontConfig config;
        config.SizePixels = std::round(size * 0.8f);
        return atlas.AddFontDefault(&config);
    }
    ImFontConfig config;
    config.OversampleH = 2;
    config.OversampleV = 1;
    ImFont* font = atlas.AddFontFromFileTTF(file.c_str(), size, &config, letters.data());
    config.MergeMode = true;
    config.GlyphMinAdvanceX = config.GlyphMaxAdvanceX = digit_width(file, size);
    atlas.AddFontFromFileTTF(file.c_str(), size, &config, digits.data());
    return font;
}

}  // namespace

Fonts load_fonts(ImFontAtlas& atlas, float scale, const render::FontFiles& files) {
    const auto size = [&](float units) { return std::round(units * scale * files.size_factor); };
    atlas.Clear();
    atlas.Flags |= ImFontAtlasFlags_NoMouseCursors;
    Fonts fonts;
    fonts.body = add_font(atlas, files.regular, size(15));
    fonts.strong = add_font(atlas, files.strong, size(15));
    fonts.small = add_font(atlas, files.regular, size(14));
    fonts.tiny = add_font(atlas, files.regular, size(12.5f));
    fonts.heading = add_font(atlas, files.strong, size(13.5f));
    fonts.source = files.regular.empty() ? "built in" : files.regular;
    atlas.Build();
    return fonts;
}

}  // namespace steplab::ui
