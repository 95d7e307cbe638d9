#include "ui/actions.hpp"

#include "render/framing.hpp"
#include "sim/catalogue.hpp"
#include "sim/run/opening.hpp"
#include "ui/input.hpp"
#include "ui/rate.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace steplab::ui {
namespace {

render::PictureSize scene_size(const Context& context) {
    const PixelRect rect = pixels(context.layout.scene);
    return {rect.width, rect.height};
}

void zoom_to_fit(const Context& context) {
    render::Camera& camera = context.stage.camera;
    camera = render::framed(context.view.frame, camera.yaw, camera.pitch, scene_size(context));
}

/// The model `offset` places further in the list; the list wraps around.
void change_scene(const Context& context, std::ptrdiff_t offset) {
    const auto all = models();
    const auto count = static_cast<std::ptrdiff_t>(all.size());
    const auto here = std::find_if(all.begin(), all.end(),
                                   [&](const Model& entry) { return entry.info.id == context.description().model; });
    const std::ptrdiff_t next = (here - all.begin() + offset + count) % count;
    context.ask(opening(with_model(context.description(), all[static_cast<std::size_t>(next)].info.id)));
}

/// The message that is drawn last. An open menu closes itself.
void close_topmost(const Context& context) {
    Session& session = context.session;
    if (ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopup)) return;
    if (session.help_open) {
        session.help_open = false;
    } else if (!session.wanted.message().empty()) {
        session.wanted.dismiss();
    } else if (session.notice) {
        session.notice.reset();
    } else if (session.lost && !session.dismissed_lost) {
        session.dismissed_lost = true;
    } else if (context.view.divergence) {
        session.dismissed_divergence = context.view.divergence->step;
    }
}

void toggle_panel(const Context& context) { context.session.panel = context.layout.panel.empty(); }

}  // namespace

void reset_view(const Context& context) {
    context.stage.camera = render::default_camera(context.view.frame, scene_size(context));
}

void perform(const Context& context, Action action) {
    Commands& run = context.commands;
    Wanted& wanted = context.session.wanted;
    switch (action) {
        case Action::pause:
            return wanted.play(!wanted.playing(), run);
        case Action::step_forward:
            return run.step_forward();
        case Action::step_back:
            return run.step_back();
        case Action::restart:
            return run.restart();
        case Action::reset_view:
            return reset_view(context);
        case Action::zoom_to_fit:
            return zoom_to_fit(context);
        case Action::faster:
            return wanted.set_rate(faster(wanted.rate()), run);
        case Action::slower:
            return wanted.set_rate(slower(wanted.rate()), run);
        case Action::previous_scene:
            return change_scene(context, -1);
        case Action::next_scene:
            return change_scene(context, 1);
        case Action::panel:
            return toggle_panel(context);
        case Action::help:
            context.session.help_open = !context.session.help_open;
            return;
        case Action::snapshot:
            return context.request({.kind = Request::Kind::save_snapshot});
        case Action::full_screen:
            return context.request({.kind = Request::Kind::full_screen});
        case Action::close:
            return close_topmost(context);
        case Action::quit:
            return context.request({.kind = Request::Kind::quit});
    }
}

void perform_pressed_keys(const Context& context) {
    if (ImGui::GetIO().WantTextInput) return;
    for (const KeyBinding& binding : key_bindings()) {
        const bool repeats = binding.action == Action::step_forward || binding.action == Action::step_back;
        if (ImGui::GetIO().KeyCtrl == binding.control && Input::pressed(binding.key, repeats)) {
            perform(context, binding.action);
        }
    }
}

std::string help_of(Action action) {
    const KeyBinding& binding = binding_of(action);
    return fmt::format("{} ({})", binding.what, binding.label);
}

}  // namespace steplab::ui
