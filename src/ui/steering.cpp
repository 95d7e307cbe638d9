#include "ui/steering.hpp"

#include "ui/input.hpp"

#include <imgui_internal.h>

#include <algorithm>
#include <array>
#include <utility>

namespace steplab::ui {
namespace {

/// The windows of ImGui that hold the panels, in the order of F6: first those over others.
constexpr std::array panels{"help",       "divergence", "doubt", "lost",      "scenes",      "lesson",
                            "panel tabs", "side panel", "plots", "time line", "run buttons", "bar"};

bool is_shown(const char* name) {
    const ImGuiWindow* const window = ImGui::FindWindowByName(name);
    return window && window->WasActive;
}

}  // namespace

void steer_on(const Context& context) {
    InterfaceState& state = context.state;
    auto here = std::find(panels.begin(), panels.end(), state.steering ? state.steered : "");
    auto next = here == panels.end() ? panels.begin() : here + 1;
    for (std::size_t tried = 0; tried <= panels.size(); ++tried, ++next) {
        if (next == panels.end()) next = panels.begin();
        if (is_shown(*next)) break;
    }
    state.steering = true;
    state.steered = *next;
    state.focused.clear();
    state.to_reveal = true;
    ImGui::ClearActiveID();  // of an entry that was being typed
    ImGui::SetWindowFocus(*next);
    ImGuiContext& imgui = *ImGui::GetCurrentContext();
    ImGui::NavInitWindow(imgui.NavWindow, true);
    imgui.NavDisableHighlight = false;
    imgui.NavDisableMouseHover = true;
}

bool is_steered(const Context& context, std::string_view panel) {
    return context.state.steering && context.state.steered == panel;
}

void scroll_by_keys(const Context& context, std::string_view panel, bool otherwise) {
    if (context.purpose != Purpose::use || ImGui::GetIO().WantTextInput) return;
    if (context.state.help_open && panel != "help") return;  // it lies over all panels
    if (!is_steered(context, panel) && (context.state.steering || !otherwise)) return;
    const int pages = Input::pressed(Key::page_down, true) - Input::pressed(Key::page_up, true);
    if (pages == 0) return;
    const float page = ImGui::GetWindowHeight() - 2 * ImGui::GetTextLineHeightWithSpacing();
    ImGui::SetScrollY(std::clamp(ImGui::GetScrollY() + static_cast<float>(pages) * page, 0.0f, ImGui::GetScrollMaxY()));
}

void leave_to_pointer(const Context& context) {
    const ImGuiIO& io = ImGui::GetIO();
    if (io.MouseClicked[0] || io.MouseClicked[1]) context.state.steering = false;
}

void draw_steering(const Context& context) {
    const ImGuiContext& imgui = *ImGui::GetCurrentContext();
    ImGuiWindow* const window = imgui.NavWindow;
    if (!context.state.steering || !window || imgui.NavId == 0) return;
    ImRect place = ImGui::WindowRectRelToAbs(window, window->NavRectRel[imgui.NavLayer]);
    if (!imgui.NavInitRequest && std::exchange(context.state.to_reveal, false)) ImGui::ScrollToRect(window, place);
    place.Expand(context.px(2));
    ImGui::GetForegroundDrawList()->AddRect(place.Min, place.Max, colour::accent, context.px(5), 0, context.px(2));
}

}  // namespace steplab::ui
