#include "ui/actions.hpp"

#include "core/error.hpp"
#include "render/framing.hpp"
#include "session/playback.hpp"
#include "sim/run/opening.hpp"
#include "ui/camera_keys.hpp"
#include "ui/input.hpp"
#include "ui/pull_keys.hpp"
#include "ui/rate.hpp"
#include "ui/size_keys.hpp"
#include "ui/steering.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace steplab::ui {
namespace {

render::PictureSize scene_size(const Context& context) {
    const PixelRect rect = context.tile();
    return {rect.width, rect.height};
}

void zoom_to_fit(const Context& context) {
    render::Camera& camera = context.stage.camera;
    camera = render::framed(context.view.frame, camera.yaw, camera.pitch, scene_size(context));
}

/// The scene `offset` places further on the page of scenes; behind the last one comes the first.
void change_scene(const Context& context, std::ptrdiff_t offset) {
    const ScenesPage& page = context.state.scenes;
    const std::string_view here = page.opening ? std::string_view(*page.opening) : id_of(context.description());
    const auto count = static_cast<std::ptrdiff_t>(page.gallery.size());
    auto place = static_cast<std::ptrdiff_t>(place_in(page.gallery, here));
    if (place == count && offset > 0) place = -1;  // a file of the user's stands before the first and behind the last
    open_exhibit(context, page.gallery[static_cast<std::size_t>((place + offset + count) % count)]);
}

/// Behind the last particle comes the first.
void select_beside(const Context& context, std::ptrdiff_t offset) {
    const auto count = static_cast<std::ptrdiff_t>(context.view.frame.positions.size());
    if (count == 0) return;
    const std::ptrdiff_t none = offset > 0 ? -1 : 0;
    const auto here = context.view.tracked ? static_cast<std::ptrdiff_t>(context.view.tracked->particle) : none;
    context.state.selection.only(static_cast<std::size_t>((here + offset + count) % count), context.events);
}

/// The message that is drawn last. An open menu closes itself.
void close_topmost(const Context& context) {
    InterfaceState& state = context.state;
    if (ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopup)) return;
    if (state.steering) {
        state.steering = false;
    } else if (state.hands.selecting) {
        state.hands.selecting = false;
    } else if (state.help_open) {
        state.help_open = false;
    } else if (!state.wanted.message().empty()) {
        state.wanted.dismiss();
    } else if (state.notice) {
        state.notice.reset();
    } else if (state.scenes.open) {
        state.scenes.open = false;
    } else if (state.lost && !state.dismissed_lost) {
        state.dismissed_lost = true;
    } else if (context.view.divergence && state.dismissed_divergence != context.view.divergence->step) {
        state.dismissed_divergence = context.view.divergence->step;
    } else {
        close_lesson(context);
    }
}

/// The same run in the other precision beside the leading one; if it is there, it goes.
void toggle_twin(const Context& context) {
    RunDescription twin = context.view.description;
    twin.precision = twin.precision == Precision::double_ ? Precision::float_ : Precision::double_;
    const auto& followers = context.session.followers;
    const auto there =
        std::find_if(followers.begin(), followers.end(), [&](const RunView& run) { return run.description == twin; });
    if (there == followers.end()) return context.events.send(event::AddRun{twin});
    context.events.send(event::RemoveRun{1 + static_cast<std::size_t>(there - followers.begin())});
}

void play_back(const Context& context) {
    Wanted& wanted = context.state.wanted;
    const bool on = !(wanted.playing() && context.session.line.backwards);
    wanted.play(on, context.events, on);
}

/// Between the marks before and behind the present moment; without them, from the start or to the last step.
void toggle_loop(const Context& context) {
    const TimeLineView& line = context.session.line;
    if (line.loop) return context.events.send(event::Loop{});
    const std::uint64_t now = context.view.frame.step;
    StepRange steps{0, line.reached};
    for (const Mark& mark : line.bookmarks) {
        if (mark.step <= now) steps.first = mark.step;
    }
    for (auto mark = line.bookmarks.rbegin(); mark != line.bookmarks.rend(); ++mark) {
        if (mark->step > now) steps.last = mark->step;
    }
    if (steps.first >= steps.last) steps = {0, line.reached};
    if (steps.last > 0) context.events.send(event::Loop{steps});
}

/// The next larger (1) or smaller (-1) of the scales; 0: the usual one.
void change_scale(const Context& context, int direction) {
    double& scale = context.state.scale;
    const auto& all = interface_scales;
    if (direction == 0) scale = 1;
    if (direction > 0) {
        const auto next = std::upper_bound(all.begin(), all.end(), scale);
        if (next != all.end()) scale = *next;
    }
    if (direction < 0) {
        const auto here = std::lower_bound(all.begin(), all.end(), scale);
        if (here != all.begin()) scale = *std::prev(here);
    }
    context.state.notice = Notice{fmt::format("text and panels: {:.0f} %", 100 * scale), ImGui::GetTime() + 2.5};
}

void toggle_panel(const Context& context) { context.state.panel = !context.layout.has_panel(); }

}  // namespace

void open_exhibit(const Context& context, const Exhibit& exhibit) {
    ScenesPage& page = context.state.scenes;
    const bool is_shown = exhibit.id == id_of(context.description()) && !context.session.playback;
    if (!exhibit.is_model && (page.opening || !is_shown)) return open_file(context, exhibit.id);
    page.open = false;
    page.opening.reset();
    if (!is_shown) context.ask(opening(with_model(context.description(), exhibit.id)));
}

void continue_from_here(const Context& context) {
    try {
        context.ask(continued(context.session));
    } catch (const UsageError& refused) {
        context.state.wanted.refuse(refused.what());
    }
}

void open_file(const Context& context, const std::string& name) {
    context.state.scenes.opening = name;
    context.request({.kind = Request::Kind::open_scene, .text = name});
}

void open_scenes_page(const Context& context, bool lessons) {
    context.state.scenes.open = true;
    context.state.scenes.lessons = lessons;
}

void close_lesson(const Context& context) {
    LessonsState& lessons = context.state.lessons;
    if (!lessons.open) return;
    lessons.open.reset();
    PlotsState& plots = context.state.plots;
    if (const std::vector<PlotChoice> own = lessons.plots.own(plots.shown); own != plots.shown) {
        plots.shown = own;
        plots.window.reset();
    }
    Wanted& wanted = context.state.wanted;
    if (const Rate own = lessons.rate.own(wanted.rate()); own != wanted.rate()) wanted.set_rate(own, context.events);
    lessons.plots.forget();
    lessons.rate.forget();
}

render::Camera home_camera(const Context& context) {
    const auto& origin = context.view.description.origin;
    const std::string_view view =
        origin && !origin->defaults.camera.empty() ? std::string_view(origin->defaults.camera) : "default";
    return render::camera_of(view, context.view.frame, scene_size(context));
}

void magnify(const Context& context, double displacements) {
    context.stage.style.displacements = displacements;
    context.events.send(event::Magnify{displacements});
}

void reset_view(const Context& context) { context.stage.camera = home_camera(context); }

void perform(const Context& context, Action action) {
    EventSink& events = context.events;
    Wanted& wanted = context.state.wanted;
    switch (action) {
        case Action::pause:
            return wanted.play(!wanted.playing(), events);
        case Action::play_back:
            return play_back(context);
        case Action::loop:
            return toggle_loop(context);
        case Action::step_forward:
            return events.send(event::Step{1});
        case Action::step_back:
            return events.send(event::Step{-1});
        case Action::restart:
            return events.send(event::Restart{});
        case Action::undo:
            context.state.hands.by_keys.reset();  // of a place that is taken back
            return events.send(event::Undo{});
        case Action::redo:
            context.state.hands.by_keys.reset();
            return events.send(event::Redo{});
        case Action::bookmark:
            return events.send(event::Bookmark{});
        case Action::turn_round:
            return events.send(event::Do{TurnRound{}});
        case Action::twin:
            return toggle_twin(context);
        case Action::next_particle:
            return select_beside(context, 1);
        case Action::previous_particle:
            return select_beside(context, -1);
        case Action::select_box:
            context.state.hands.selecting = !context.state.hands.selecting;
            return;
        case Action::reset_view:
            return reset_view(context);
        case Action::zoom_to_fit:
            return zoom_to_fit(context);
        case Action::faster:
            return wanted.set_rate(faster(wanted.rate()), events);
        case Action::slower:
            return wanted.set_rate(slower(wanted.rate()), events);
        case Action::previous_scene:
            return change_scene(context, -1);
        case Action::next_scene:
            return change_scene(context, 1);
        case Action::open_scene:
            context.state.scenes.open = context.state.scenes.to_type = !context.state.scenes.open;
            context.state.scenes.lessons = false;
            return;
        case Action::save_scene:
            return context.request({.kind = Request::Kind::save_scene});
        case Action::panel:
            return toggle_panel(context);
        case Action::steer:
            return steer_on(context);
        case Action::larger:
            return change_scale(context, 1);
        case Action::smaller:
            return change_scale(context, -1);
        case Action::usual_scale:
            return change_scale(context, 0);
        case Action::help:
            context.state.help_open = !context.state.help_open;
            return;
        case Action::snapshot:
            return context.request({.kind = Request::Kind::save_snapshot});
        case Action::record:
            return context.request({.kind = Request::Kind::record});
        case Action::full_screen:
            return context.request({.kind = Request::Kind::full_screen});
        case Action::close:
            return close_topmost(context);
        case Action::quit:
            return context.request({.kind = Request::Kind::quit});
    }
}

namespace {

/// Keys of the run and the view do nothing while the page of scenes hides both.
bool acts_on_page(Action action) {
    constexpr std::array actions{Action::open_scene, Action::help,        Action::larger,
                                 Action::smaller,    Action::usual_scale, Action::full_screen,
                                 Action::close,      Action::quit,        Action::steer};
    return std::find(actions.begin(), actions.end(), action) != actions.end();
}

/// A field that is being edited keeps all other keys to itself: a scene would be saved without the value that is typed.
bool acts_beside_an_entry(Action action) {
    constexpr std::array actions{Action::larger,      Action::smaller,  Action::usual_scale,
                                 Action::help,        Action::snapshot, Action::record,
                                 Action::full_screen, Action::quit,     Action::steer};
    return std::find(actions.begin(), actions.end(), action) != actions.end();
}

/// Held, the key does it again and again.
bool is_repeated(Action action) {
    return action == Action::step_forward || action == Action::step_back || action == Action::next_particle ||
           action == Action::previous_particle;
}

/// Keys that belong to the panel that the keyboard is in.
bool goes_to_widgets(const Context& context, Key key) {
    if (!context.state.steering) return false;
    const bool moves_axes = key == Key::equal || key == Key::minus || key == Key::bracket_left ||
                            key == Key::bracket_right || key == Key::home;
    const std::string& focused = context.state.focused;
    const bool of_a_plot = focused != "plots.add" && !focused.ends_with(".tab");
    if (moves_axes && of_a_plot && is_steered(context, "plots")) return true;
    return key == Key::space || key == Key::left || key == Key::right;
}

}  // namespace

void perform_pressed_keys(const Context& context) {
    if (use_pull_keys(context) || use_camera_keys(context) || use_size_keys(context)) return;
    for (const KeyBinding& binding : key_bindings()) {
        if (ImGui::GetIO().WantTextInput && !acts_beside_an_entry(binding.action)) continue;
        if (context.state.scenes.open && !acts_on_page(binding.action)) continue;
        if (!binding.control && goes_to_widgets(context, binding.key)) continue;
        const bool repeats = is_repeated(binding.action);
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
