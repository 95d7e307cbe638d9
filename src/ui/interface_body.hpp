#pragma once

#include "ui/context.hpp"
#include "ui/follower.hpp"
#include "ui/imgui_clipboard.hpp"
#include "ui/input.hpp"
#include "ui/interface.hpp"
#include "ui/trail.hpp"
#include "ui/view_keeper.hpp"

#include <imgui.h>

#include <memory>
#include <optional>

namespace steplab::ui {

/// What an interface keeps.
struct Interface::Body {
    Body(ImGuiContext* made, const Display& size) : context(made), display(size) { theme.apply(display.scale); }

    struct ContextDeleter {
        void operator()(ImGuiContext* old) const { ImGui::DestroyContext(old); }
    };
    std::unique_ptr<ImGuiContext, ContextDeleter> context;
    Display display;  ///< in the scale that the person chose
    Theme theme;
    Input input;
    ImGuiClipboard clipboard;
    InterfaceState state;
    ViewKeeper view_keeper;
    Follower follower;
    Trails trails;
    Layout layout;
    WidgetMap widgets;
    std::optional<double> frame_seconds;  ///< as measured for the last frame
    bool new_view = true;
    bool input_left = false;
    bool unsettled = true;  ///< a widget appeared, disappeared or moved; ImGui knows its size one frame later
};

}  // namespace steplab::ui
