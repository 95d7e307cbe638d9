#include "render/sketch.hpp"

#include "render/font_files.hpp"
#include "render/imgui_renderer.hpp"
#include "render/scene_renderer.hpp"

#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace steplab::render {
namespace {

constexpr double text_height = 13.5;  // pixels at scale 1

ImU32 packed(Rgb colour, double opacity) {
    return IM_COL32(colour.red, colour.green, colour.blue, std::lround(255 * std::clamp(opacity, 0.0, 1.0)));
}

ImVec2 vec(PixelPoint point) { return {static_cast<float>(point.x), static_cast<float>(point.y)}; }

void fill(ImFontAtlas& atlas, double pixel_scale) {
    const FontFiles files = find_font_files();
    const auto size = static_cast<float>(std::round(text_height * pixel_scale * files.size_factor));
    atlas.Clear();
    atlas.Flags |= ImFontAtlasFlags_NoMouseCursors;
    if (files.regular.empty()) {
        atlas.AddFontDefault();
    } else {
        atlas.AddFontFromFileTTF(files.regular.c_str(), size);
    }
}

}  // namespace

struct Sketch::Body {
    ImguiRenderer renderer;
    ImFontAtlas atlas;
    ImDrawListSharedData shared;
    ImDrawList list{&shared};
    double pixel_scale = 0;

    void use_fonts(double scale) {
        if (scale == pixel_scale) return;
        pixel_scale = scale;
        fill(atlas, scale);
        renderer.upload_fonts(atlas);
        shared.Font = atlas.Fonts[0];
        shared.FontSize = shared.Font->FontSize;
        shared.TexUvWhitePixel = atlas.TexUvWhitePixel;
        shared.TexUvLines = atlas.TexUvLines;
        shared.InitialFlags = ImDrawListFlags_AntiAliasedLines | ImDrawListFlags_AntiAliasedFill;
        shared.SetCircleTessellationMaxError(0.1F);
    }
};

Sketch::Sketch() : body_(std::make_unique<Body>()) {}
Sketch::~Sketch() = default;
Sketch::Sketch(Sketch&&) noexcept = default;
Sketch& Sketch::operator=(Sketch&&) noexcept = default;

void Sketch::begin(PictureSize size, double pixel_scale) {
    body_->use_fonts(pixel_scale);
    body_->shared.ClipRectFullscreen = {0, 0, static_cast<float>(size.width), static_cast<float>(size.height)};
    body_->list._ResetForNewFrame();
    body_->list.PushTextureID(body_->atlas.TexID);
    body_->list.PushClipRectFullScreen();
}

PixelPoint Sketch::text_size(const std::string& text) const {
    const ImFont& font = *body_->shared.Font;
    const ImVec2 size = font.CalcTextSizeA(font.FontSize, FLT_MAX, 0, text.c_str());
    return {size.x, size.y};
}

void Sketch::text(PixelPoint top_left, const std::string& text, Rgb colour, double opacity) {
    // On whole pixels the glyphs are sharp.
    const PixelPoint place{std::round(top_left.x), std::round(top_left.y)};
    constexpr double farthest = 1e6;  // ImGui places glyphs by whole numbers
    if (!(std::abs(place.x) < farthest && std::abs(place.y) < farthest)) return;
    body_->list.AddText(vec(place), packed(colour, opacity), text.c_str());
}

void Sketch::text_over(PixelPoint top_left, const std::string& text, Rgb colour, Rgb ground) {
    const double rim = std::max(1.0, std::round(body_->pixel_scale));  // texts lie on whole pixels
    for (const double x : {-rim, 0.0, rim}) {
        for (const double y : {-rim, 0.0, rim}) {
            if (x != 0 || y != 0) this->text({top_left.x + x, top_left.y + y}, text, ground, veil);
        }
    }
    this->text(top_left, text, colour);
}

void Sketch::line(PixelPoint from, PixelPoint to, Rgb colour, double width, double opacity) {
    body_->list.AddLine(vec(from), vec(to), packed(colour, opacity), static_cast<float>(width));
}

void Sketch::disc(PixelPoint centre, double radius, Rgb colour, double opacity) {
    body_->list.AddCircleFilled(vec(centre), static_cast<float>(radius), packed(colour, opacity));
}

void Sketch::outline(PixelPoint centre, double radius, int corners, double first, Rgb colour, double width) {
    const ImU32 ink = packed(colour, 1);
    if (corners < 3)
        return body_->list.AddCircle(vec(centre), static_cast<float>(radius), ink, 0, static_cast<float>(width));
    constexpr double turn = 2 * std::numbers::pi;
    for (int i = 0; i < corners; ++i) {
        const double angle = turn * (first + static_cast<double>(i) / corners);
        body_->list.PathLineTo(vec({centre.x + radius * std::cos(angle), centre.y - radius * std::sin(angle)}));
    }
    body_->list.PathStroke(ink, ImDrawFlags_Closed, static_cast<float>(width));
}

void Sketch::box(PixelPoint top_left, PixelPoint bottom_right, Rgb colour, double opacity) {
    body_->list.AddRectFilled(vec(top_left), vec(bottom_right), packed(colour, opacity));
}

void Sketch::shaded_box(PixelPoint top_left, PixelPoint bottom_right, Rgb top, Rgb bottom) {
    const ImU32 above = packed(top, 1);
    const ImU32 below = packed(bottom, 1);
    body_->list.AddRectFilledMultiColor(vec(top_left), vec(bottom_right), above, above, below, below);
}

void Sketch::finish(const Tile& tile, PictureSize part) {
    ImDrawData data;
    data.Valid = true;
#if IMGUI_VERSION_NUM >= 18980
    data.CmdLists.push_back(&body_->list);
#else
    ImDrawList* lists[] = {&body_->list};
    data.CmdLists = lists;
#endif
    data.CmdListsCount = 1;
    data.DisplayPos = {static_cast<float>(tile.left), static_cast<float>(tile.top)};
    data.DisplaySize = {static_cast<float>(part.width), static_cast<float>(part.height)};
    data.FramebufferScale = {1, 1};
    body_->renderer.draw(data);
}

}  // namespace steplab::render
