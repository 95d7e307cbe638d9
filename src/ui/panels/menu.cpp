#include "render/framing.hpp"
#include "session/session.hpp"
#include "ui/actions.hpp"
#include "ui/panels/method_items.hpp"
#include "ui/panels/panels.hpp"
#include "ui/widgets/icons.hpp"
#include "ui/widgets/widgets.hpp"
#include "ui/window_command.hpp"

#include <optional>
#include <utility>
#include <vector>

namespace steplab::ui {
namespace {

void copy(const Context& context, std::string text, std::string_view what) {
    context.request({.kind = Request::Kind::copy_text, .text = std::move(text)});
    context.state.notice = Notice{"copied " + std::string(what), ImGui::GetTime() + 2.5};
}

bool menu_item(const Context& context, std::string_view widget, const char* label, std::string_view key = {}) {
    const bool chosen = ImGui::MenuItem(label, key.empty() ? nullptr : std::string(key).c_str());
    context.mark(widget);
    return chosen;
}

void action_item(const Context& context, std::string_view widget, const char* label, Action action) {
    if (menu_item(context, widget, label, binding_of(action).label)) perform(context, action);
}

/// Panels and plots as a window shows them that remembers nothing.
void reset_layout(InterfaceState& state) {
    const ViewChoices usual;
    state.scale = usual.scale;
    state.panel = usual.panel;
    state.sizes = usual.sizes;
    state.plots.shown = usual.plots;
    state.plots.window.reset();
}

void check_item(const Context& context, std::string_view widget, const char* label, bool& on, bool enabled = true) {
    if (ImGui::MenuItem(label, nullptr, on, enabled)) on = !on;
    context.mark(widget);
}

/// A menu beside an item of the menu, with what `items` draws.
template <class Items>
void menu_beside(const Context& context, std::string_view widget, const char* label, const Items& items,
                 bool enabled = true) {
    const bool open = ImGui::BeginMenu(label, enabled);
    context.mark(widget);
    if (!open) return;
    items();
    ImGui::EndMenu();
}

/// What pictures and films show, and how films are written.
void draw_picture_items(const Context& context) {
    PictureChoice& picture = context.state.picture;
    check_item(context, "menu/scene alone", "Scene alone", picture.scene_alone);
    check_item(context, "menu/caption", "Caption", picture.caption);
    ImGui::Separator();
    for (const std::string_view ending : film_endings) {
        const std::string label(ending);
        const bool chosen = ImGui::MenuItem(("Films as " + label).c_str(), nullptr, ending == picture.film,
                                            !context.state.film.has_value());
        if (chosen) picture.film = label;
        context.mark("menu/films/" + label);
    }
}

void draw_playing_items(const Context& context) {
    action_item(context, "menu/play back", "Play backwards", Action::play_back);
    action_item(context, "menu/loop", "Repeat", Action::loop);
    action_item(context, "menu/faster", "Play faster", Action::faster);
    action_item(context, "menu/slower", "Play slower", Action::slower);
}

/// What stands as buttons over the plots, where the window has room for them.
void draw_run_items(const Context& context) {
    const std::size_t runs = 1 + context.session.followers.size();
    const std::vector<ComboItem> methods = method_items(context.view);
    size_item_list(context, methods);
    menu_beside(
        context, "menu/add run", "+ method",
        [&] {
            if (const auto chosen = item_list(context, "menu/add run", methods, std::nullopt))
                context.events.send(event::AddRun{with_method(context.description(), methods[*chosen].id)});
        },
        runs < Session::most_runs);
    action_item(context, "menu/twin", "Twin", Action::twin);
    action_item(context, "menu/turn round", "Turn round", Action::turn_round);
    bool equal = context.session.equal_cost;
    check_item(context, "menu/equal cost", "Equal cost", equal, runs > 1);
    if (equal != context.session.equal_cost) context.events.send(event::EqualCost{equal});
}

void draw_scale_items(const Context& context) {
    action_item(context, "menu/larger", "Larger", Action::larger);
    action_item(context, "menu/smaller", "Smaller", Action::smaller);
    action_item(context, "menu/usual scale", "As usual", Action::usual_scale);
}

void draw_menu_items(const Context& context) {
    if (menu_item(context, "menu/copy command", "Copy command line")) {
        copy(context, window_command(context),
             command_repeats_run(context)
                 ? "the command line that opens this again"
                 : "the command line; it opens the start, without the changes during this run");
    }
    if (menu_item(context, "menu/copy view", "Copy view")) {
        copy(context, render::view_text(context.stage.camera), "the view");
    }
    ImGui::Separator();
    if (context.session.playback && context.session.playback->measured &&
        menu_item(context, "menu/continue", "Continue from here"))
        continue_from_here(context);
    action_item(context, "menu/open scene", "Scenes ...", Action::open_scene);
    if (menu_item(context, "menu/try", "Try a lesson ...")) open_scenes_page(context, true);
    action_item(context, "menu/save scene", "Save scene", Action::save_scene);
    if (menu_item(context, "menu/save session", "Save session")) context.request({.kind = Request::Kind::save_session});
    action_item(context, "menu/snapshot", "Save snapshot", Action::snapshot);
    action_item(context, "menu/record", context.state.film ? "End the film" : "Record a film", Action::record);
    menu_beside(context, "menu/pictures", "Pictures and films show", [&] { draw_picture_items(context); });
    action_item(context, "menu/reset view", "Reset view", Action::reset_view);
    action_item(context, "menu/zoom to fit", "Zoom to fit", Action::zoom_to_fit);
    ImGui::Separator();
    action_item(context, "menu/undo", "Undo", Action::undo);
    action_item(context, "menu/redo", "Redo", Action::redo);
    action_item(context, "menu/bookmark", "Mark this moment", Action::bookmark);
    action_item(context, "menu/select box", "Select a box", Action::select_box);
    menu_beside(context, "menu/particles", "Select a particle", [&] {
        action_item(context, "menu/next particle", "Next", Action::next_particle);
        action_item(context, "menu/previous particle", "Before", Action::previous_particle);
    });
    ImGui::Separator();
    if (!context.session.playback) menu_beside(context, "menu/runs", "Runs", [&] { draw_run_items(context); });
    menu_beside(context, "menu/playing", "Playing", [&] { draw_playing_items(context); });
    action_item(context, "menu/previous scene", "Previous scene", Action::previous_scene);
    action_item(context, "menu/next scene", "Next scene", Action::next_scene);
    ImGui::Separator();
    action_item(context, "menu/panel", "Show or hide panel", Action::panel);
    action_item(context, "menu/steer", "Panels by keyboard", Action::steer);
    menu_beside(context, "menu/text size", "Text size", [&] { draw_scale_items(context); });
    if (menu_item(context, "menu/reset layout", "Reset layout")) reset_layout(context.state);
    action_item(context, "menu/full screen", "Full screen", Action::full_screen);
    action_item(context, "menu/help", "Help", Action::help);
    action_item(context, "menu/quit", "Quit", Action::quit);
}

}  // namespace

void draw_menu(const Context& context) {
    if (icon_button(context, "menu", Icon::menu, "menu")) ImGui::OpenPopup("menu");
    const Area& bar = context.layout.bar;
    ImGui::SetNextWindowPos({bar.right() - context.px(8), bar.bottom() + context.px(4)}, ImGuiCond_Always, {1, 0});
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {context.px(24), context.px(8)});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {context.px(14), context.px(12)});
    const float room = static_cast<float>(context.display.height) - bar.bottom() - context.px(8);
    ImGui::SetNextWindowSizeConstraints({0, 0}, {static_cast<float>(context.display.width), room});
    if (ImGui::BeginPopup("menu", ImGuiWindowFlags_NoMove)) {
        close_if_asked(context);
        draw_menu_items(context);
        ImGui::EndPopup();
    }
    ImGui::PopStyleVar(2);
}

}  // namespace steplab::ui
