#include "ui/widgets/colours.hpp"

namespace steplab::ui {
namespace {

constexpr ImU32 rgb(unsigned hex, unsigned alpha = 255) {
    return IM_COL32((hex >> 16) & 0xff, (hex >> 8) & 0xff, hex & 0xff, alpha);
}

// Text has a contrast of 4.5 or more (WCAG 2) on everything that it is written on, curves and knobs of 3 or more.
constexpr Colours dark{.panel = rgb(0x1c2128),
                       .backdrop = rgb(0x12151a),
                       .card = rgb(0x15181e, 235),
                       .window = rgb(0x171b21, 245),
                       .popup = rgb(0x20262e, 250),
                       .line = rgb(0x2a313b),
                       .control = rgb(0x262d36),
                       .control_hover = rgb(0x303944),
                       .control_active = rgb(0x3a4553),
                       .track = rgb(0x323a45),
                       .knob = rgb(0xd7dde5),
                       .text = rgb(0xd7dde5),
                       .text_dim = rgb(0xaab4c1),
                       .text_faint = rgb(0x8c97a6),
                       .bright = rgb(0xffffff),
                       .accent = rgb(0x4ea1ff),
                       .accent_hover = rgb(0x6cb2ff),
                       .on_accent = rgb(0x0c1420),
                       .selection = rgb(0x4ea1ff, 110),
                       .good = rgb(0x3fb37f),
                       .caution = rgb(0xe0a33e),
                       .bad = rgb(0xe67a7a),
                       .exact = rgb(0xf0f3f7)};
constexpr Colours light{.panel = rgb(0xf6f8fa),
                        .backdrop = rgb(0xe6eaef),
                        .card = rgb(0xffffff, 235),
                        .window = rgb(0xffffff, 245),
                        .popup = rgb(0xffffff, 250),
                        .line = rgb(0xcfd6de),
                        .control = rgb(0xe3e8ee),
                        .control_hover = rgb(0xd6dde6),
                        .control_active = rgb(0xc6d0db),
                        .track = rgb(0xc9d1da),
                        .knob = rgb(0x46515f),
                        .text = rgb(0x1b222b),
                        .text_dim = rgb(0x434d5a),
                        .text_faint = rgb(0x56616f),
                        .bright = rgb(0x000000),
                        .accent = rgb(0x1b69cf),
                        .accent_hover = rgb(0x1459b3),
                        .on_accent = rgb(0xffffff),
                        .selection = rgb(0x1b69cf, 80),
                        .good = rgb(0x127043),
                        .caution = rgb(0x8a5a00),
                        .bad = rgb(0xb92c2c),
                        .exact = rgb(0x20262e)};

}  // namespace

const Colours& colours_of(render::Background theme) { return theme == render::Background::dark ? dark : light; }

void use_colours(render::Background theme) {
    // Constant, so ImGui's pointer is not used to write.
    ImGui::GetIO().UserData = const_cast<Colours*>(&colours_of(theme));
}

const Colours& colours() {
    const void* chosen = ImGui::GetCurrentContext() ? ImGui::GetIO().UserData : nullptr;
    return chosen ? *static_cast<const Colours*>(chosen) : dark;
}

}  // namespace steplab::ui
