#pragma once

#include "render/style.hpp"

#include <imgui.h>

namespace steplab::ui {

/// The colours of the interface in one theme.
struct Colours {
    ImU32 panel;     ///< side panel, bars, plots
    ImU32 backdrop;  ///< behind the panels
    ImU32 card;      ///< behind readings over the scene
    ImU32 window;    ///< cards with controls
    ImU32 popup;     ///< menus, tooltips
    ImU32 line;      ///< borders, separators, grid lines of plots
    ImU32 control;   ///< buttons, combos, entries
    ImU32 control_hover;
    ImU32 control_active;
    ImU32 track;  ///< of a slider
    ImU32 knob;
    ImU32 text;
    ImU32 text_dim;
    ImU32 text_faint;
    ImU32 bright;  ///< text and knobs under the pointer
    ImU32 accent;
    ImU32 accent_hover;
    ImU32 on_accent;  ///< text on these
    ImU32 selection;  ///< behind selected text
    ImU32 good;
    ImU32 caution;  ///< works, but not well
    ImU32 bad;
    ImU32 exact;  ///< the exact solution in plots
};

const Colours& colours_of(render::Background theme);

/// Makes a theme that of the current ImGui context.
void use_colours(render::Background theme);
/// The colours of the current ImGui context; those of the dark theme without one and before use_colours().
const Colours& colours();

/// A colour by its role. Where it is used, it is the colour of that role in the current ImGui context, as ImGui's own
/// style is.
class Ink {
public:
    constexpr explicit Ink(ImU32 Colours::*role) : role_(role) {}
    operator ImU32() const { return colours().*role_; }  // NOLINT(google-explicit-constructor): it stands for a colour

private:
    ImU32 Colours::*role_;
};

namespace colour {
inline constexpr Ink panel{&Colours::panel};
inline constexpr Ink backdrop{&Colours::backdrop};
inline constexpr Ink card{&Colours::card};
inline constexpr Ink window{&Colours::window};
inline constexpr Ink popup{&Colours::popup};
inline constexpr Ink line{&Colours::line};
inline constexpr Ink control{&Colours::control};
inline constexpr Ink control_hover{&Colours::control_hover};
inline constexpr Ink control_active{&Colours::control_active};
inline constexpr Ink track{&Colours::track};
inline constexpr Ink knob{&Colours::knob};
inline constexpr Ink text{&Colours::text};
inline constexpr Ink text_dim{&Colours::text_dim};
inline constexpr Ink text_faint{&Colours::text_faint};
inline constexpr Ink bright{&Colours::bright};
inline constexpr Ink accent{&Colours::accent};
inline constexpr Ink accent_hover{&Colours::accent_hover};
inline constexpr Ink on_accent{&Colours::on_accent};
inline constexpr Ink selection{&Colours::selection};
inline constexpr Ink good{&Colours::good};
inline constexpr Ink caution{&Colours::caution};
inline constexpr Ink bad{&Colours::bad};
inline constexpr Ink exact{&Colours::exact};
}  // namespace colour

}  // namespace steplab::ui
