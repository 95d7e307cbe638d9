#include "ui/panels/card_corner.hpp"

#include "render/bounds.hpp"

#include <imgui_internal.h>

#include <algorithm>
#include <array>
#include <vector>

namespace steplab::ui {
namespace {

constexpr float beside_corner = 8;  // units of the layout
/// Less than this part of the oscillation is not worth a move.
constexpr double hardly_any = 0.01;

/// A particle on the display, and its part of the oscillation; the particle that the card names counts as one that
/// moves as far as any.
struct Swing {
    ImVec2 place;
    double part = 0;
};

std::vector<Swing> swings(const Context& context) {
    const Frame& frame = context.view.frame;
    std::vector<Swing> all;
    if (frame.oscillation.size() != frame.positions.size()) return all;
    const render::Projection projection = context.projection();
    const PixelRect tile = context.tile();
    double sum = 0;
    for (std::size_t i = 0; i < frame.positions.size(); ++i) {
        const bool is_named = context.view.divergence && context.view.divergence->particle == i;
        const double part = dot(frame.oscillation[i], frame.oscillation[i]) + (is_named ? 1 : 0);
        const Vec3 seen = frame.seen(i);
        const auto pixel = part > 0 && render::drawable(seen) ? projection.pixel(seen) : std::nullopt;
        if (!pixel) continue;
        all.push_back({{static_cast<float>(tile.x + pixel->x), static_cast<float>(tile.y + pixel->y)}, part});
        sum += part;
    }
    for (Swing& each : all) each.part /= sum;
    return all;
}

/// Lower right, lower left, upper right, upper left: readings stand in the upper ones.
CardCorner corner_of(const Context& context, std::size_t number) {
    const Area& scene = context.layout.scene;
    const float margin = context.px(beside_corner);
    const bool left = number % 2 == 1, upper = number >= 2;
    return {{left ? scene.x + margin : scene.right() - margin, upper ? scene.y + margin : scene.bottom() - margin},
            {left ? 0.0f : 1.0f, upper ? 0.0f : 1.0f}};
}

/// The part of the oscillation behind a card there, which stays on the display where the scene is too low for it.
double hidden(const Context& context, const std::vector<Swing>& all, const CardCorner& corner, ImVec2 size) {
    const float around = context.px(14);  // of a particle with its arrow
    const float lowest = static_cast<float>(context.display.height) - context.px(beside_corner) - size.y;
    const float left = corner.anchor.x - corner.pivot.x * size.x;
    const float top = std::clamp(corner.anchor.y - corner.pivot.y * size.y, 0.0f, std::max(0.0f, lowest));
    double part = 0;
    for (const Swing& each : all) {
        const auto [x, y] = each.place;
        if (x > left - around && x < left + size.x + around && y > top - around && y < top + size.y + around)
            part += each.part;
    }
    return part;
}

/// A card does not go away under the pointer.
bool is_in_use(const Context& context, const ImGuiWindow& card) {
    if (context.purpose != Purpose::use) return false;
    const ImGuiIO& io = ImGui::GetIO();
    return io.MouseDown[0] || io.MouseDown[1] || (card.WasActive && card.Rect().Contains(io.MousePos));
}

}  // namespace

CardCorner card_corner(const Context& context, const char* card) {
    std::size_t& chosen = context.state.card_corner;
    const ImGuiWindow* const before = ImGui::FindWindowByName(card);
    if (before && !is_in_use(context, *before)) {
        const std::vector<Swing> all = swings(context);
        const auto behind = [&](std::size_t number) {
            return hidden(context, all, corner_of(context, number), before->Size);
        };
        double least = behind(chosen);
        for (std::size_t number = 0; number < 4 && least > hardly_any; ++number) {
            const double part = behind(number);
            if (part >= least - hardly_any) continue;
            least = part;
            chosen = number;
        }
    }
    return corner_of(context, chosen);
}

}  // namespace steplab::ui
