#include "core/number_text.hpp"
#include "core/shown.hpp"
#include "ui/panels/panels.hpp"
#include "ui/widgets/format.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

namespace steplab::ui {
namespace {

ImVec2 shifted(ImVec2 from, ImVec2 along, float far) { return {from.x + far * along.x, from.y + far * along.y}; }

/// Where a place in the scene of the leading run is on the display.
std::optional<ImVec2> on_display(const Context& context, Vec3 place) {
    const auto pixel = render::drawable(place) ? context.projection().pixel(place) : std::nullopt;
    if (!pixel) return std::nullopt;
    const PixelRect tile = context.tile();
    return ImVec2{static_cast<float>(tile.x + pixel->x), static_cast<float>(tile.y + pixel->y)};
}

/// Where one of its particles is.
std::optional<ImVec2> on_display(const Context& context, std::size_t particle) {
    const Frame& frame = context.view.frame;
    return particle < frame.positions.size() ? on_display(context, frame.seen(particle)) : std::nullopt;
}

/// A line from one point to another.
struct Stroke {
    ImVec2 from, to;
    ImVec2 along{}, across{};
    float length = 0;

    Stroke(ImVec2 a, ImVec2 b) : from(a), to(b), length(std::hypot(b.x - a.x, b.y - a.y)) {
        if (length > 0) along = {(b.x - a.x) / length, (b.y - a.y) / length};
        across = {-along.y, along.x};
    }
};

/// As a coil, so that it is not taken for one of the scene's springs.
void draw_spring(const Context& context, ImDrawList& list, const Stroke& line) {
    constexpr int turns = 9;
    const float end = std::min(context.px(10), 0.2f * line.length), width = context.px(5);
    if (line.length < context.px(8)) return;
    const float pitch = (line.length - 2 * end) / (2 * turns);
    std::array<ImVec2, 2 * turns + 3> points{};
    points.front() = line.from;
    for (int i = 0; i <= 2 * turns; ++i) {
        const bool at_end = i == 0 || i == 2 * turns;
        const float side = at_end ? 0 : (i % 2 == 0 ? -width : width);
        points[static_cast<std::size_t>(i) + 1] =
            shifted(shifted(line.from, line.along, end + static_cast<float>(i) * pitch), line.across, side);
    }
    points.back() = line.to;
    list.AddPolyline(points.data(), static_cast<int>(points.size()), colour::accent, 0, context.px(2));
    list.AddCircleFilled(line.to, context.px(3.5f), colour::accent);
}

void draw_text(const Context& context, ImDrawList& list, ImVec2 place, const std::string& text) {
    ImFont* const font = context.theme.fonts().small;
    const ImVec2 size = font->CalcTextSizeA(font->FontSize, 1e9f, 0, text.c_str());
    const Area& scene = context.layout.scene;
    const float margin = context.px(5);
    const float x =
        std::clamp(place.x + context.px(14), scene.x, std::max(scene.x, scene.right() - size.x - 2 * margin));
    const float y = std::clamp(place.y - 0.5f * size.y, scene.y + margin,
                               std::max(scene.y + margin, scene.bottom() - size.y - margin));
    list.AddRectFilled({x - margin, y - margin}, {x + size.x + margin, y + size.y + margin}, colour::card,
                       context.px(4));
    list.AddText(font, font->FontSize, {x, y}, colour::text, text.c_str());
}

void draw_arrow(const Context& context, ImDrawList& list, const Stroke& line) {
    const float head = std::min(context.px(12), line.length), half = 0.5f * head;
    const ImVec2 neck = shifted(line.to, line.along, -head);
    if (line.length < context.px(4)) return;
    list.AddLine(line.from, neck, colour::accent, context.px(3));
    list.AddTriangleFilled(line.to, shifted(neck, line.across, half), shifted(neck, line.across, -half),
                           colour::accent);
    draw_text(context, list, line.to, with_unit(rounded_text(length(context.state.hands.kick)), "m/s"));
}

void draw_box(const Context& context, ImDrawList& list, ImVec2 pointer) {
    const PixelRect tile = context.tile();
    const render::PixelPoint from = *context.state.hands.box_from;
    const ImVec2 corner{static_cast<float>(tile.x + from.x), static_cast<float>(tile.y + from.y)};
    const ImVec2 low{std::min(corner.x, pointer.x), std::min(corner.y, pointer.y)};
    const ImVec2 high{std::max(corner.x, pointer.x), std::max(corner.y, pointer.y)};
    list.AddRectFilled(low, high, (colour::accent & ~IM_COL32_A_MASK) | (ImU32{40} << IM_COL32_A_SHIFT));
    list.AddRect(low, high, colour::accent, 0, 0, context.px(1.5f));
}

/// What the file has of it besides, as many columns as are read at a glance.
std::string values_of(const Frame& frame, std::size_t particle) {
    constexpr std::size_t most = 6;
    std::string text;
    if (!frame.values) return text;
    for (std::size_t i = 0; i < std::min(most, frame.values->size()); ++i) {
        const ParticleValues& column = (*frame.values)[i];
        text += fmt::format("\n{} {}", shown(column.name, 24), typed(column.values[particle], 4));
    }
    return text;
}

/// What a particle is doing.
std::string numbers_of(const Context& context, std::size_t particle) {
    const RunView& view = context.view;
    const Frame& frame = view.frame;
    std::string text = fmt::format("particle {}", particle);
    if (frame.shape->roles[particle] != Role::moving) text += fmt::format(" ({})", id(frame.shape->roles[particle]));
    if (const double mass = mass_of(view, particle); mass > 0) text += "   " + with_unit(setting_text(mass), "kg");
    return text +
           fmt::format("\nat {} m\nvelocity {} m/s", vector(frame.seen_at(frame.positions[particle])),
                       vector(frame.velocities[particle])) +
           values_of(frame, particle);
}

/// From a particle to where keys pull it.
void draw_key_pull(const Context& context, ImDrawList& list, const KeyPull& pull) {
    const auto particle = on_display(context, pull.particle), place = on_display(context, pull.place);
    if (particle && place) draw_spring(context, list, {*particle, *place});
}

void draw_numbers(const Context& context, ImDrawList& list) {
    const auto particle = context.state.pointed;
    const auto place = particle ? on_display(context, *particle) : std::nullopt;
    if (place)
        draw_text(context, list, {place->x + context.px(8), place->y - context.px(34)}, numbers_of(context, *particle));
}

}  // namespace

void draw_hands(const Context& context) {
    if (context.purpose != Purpose::use) return;
    const Hands& hands = context.state.hands;
    const Area& scene = context.layout.scene;
    const ImVec2 pointer = ImGui::GetIO().MousePos;
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    list.PushClipRect({scene.x, scene.y}, {scene.right(), scene.bottom()});
    const auto from_particle = [&](std::optional<std::size_t> particle) {
        return particle ? on_display(context, *particle) : std::nullopt;
    };
    if (const auto place = from_particle(hands.pulled)) {
        draw_spring(context, list, {*place, pointer});
    } else if (const auto origin = from_particle(hands.kicked)) {
        draw_arrow(context, list, {*origin, pointer});
    } else if (hands.box_from) {
        draw_box(context, list, pointer);
    } else if (hands.by_keys) {
        draw_key_pull(context, list, *hands.by_keys);
    } else {
        draw_numbers(context, list);
    }
    list.PopClipRect();
}

}  // namespace steplab::ui
