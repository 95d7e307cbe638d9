#include "ui/actions.hpp"
#include "ui/interface_body.hpp"
#include "ui/panels/panels.hpp"
#include "ui/scene_pointer.hpp"
#include "ui/steering.hpp"
#include "ui/widgets/widgets.hpp"

#include <imgui_internal.h>

#include <algorithm>
#include <limits>
#include <utility>

namespace steplab::ui {
namespace {

/// Ignores all events: a snapshot has no user.
class NoEvents final : public EventSink {
public:
    void send(const Event&) override {}
    void begin(const RunDescription&) override {}
    void play_part(const FilmPart&) override {}
};

/// A context that reads and writes no files.
ImGuiContext* make_context() {
    ImGuiContext* context = ImGui::CreateContext();
    ImGui::SetCurrentContext(context);
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;
    io.LogFilename = nullptr;
    io.BackendFlags |= ImGuiBackendFlags_RendererHasVtxOffset | ImGuiBackendFlags_HasGamepad;
    io.ConfigInputTextCursorBlink = false;
    Input::describe_keys(io);
    return context;
}

/// Beyond these glyphs are unreadable, or take more memory than a texture has.
constexpr float least_scale = 0.5f, most_scale = 8;

/// What was drawn last loses its open menus, which stay open: a film goes on while its person chooses from one.
void leave_out_menus() {
    for (const ImGuiWindow* const window : ImGui::GetCurrentContext()->Windows)
        if (window->Active && (window->Flags & ImGuiWindowFlags_Popup) != 0) window->DrawList->_ResetForNewFrame();
}

/// Right of the window, so that neither lies over the other: as large as the plots are, and no smaller than what is
/// written in one takes.
PicturedPlot pictured_plot(const std::string& name, const Area& plots, const Display& display) {
    constexpr float least_width = 960, least_height = 540;
    return {name, Area{static_cast<float>(display.width), 0, std::max(plots.width, least_width * display.scale),
                       std::max(plots.height, least_height * display.scale)}};
}

/// Of all that is drawn.
ImVec2 size_of(const Display& display, const std::optional<PicturedPlot>& plot) {
    const auto width = static_cast<float>(display.width), height = static_cast<float>(display.height);
    return plot ? ImVec2{plot->area.right(), std::max(height, plot->area.bottom())} : ImVec2{width, height};
}

/// What lies over all else.
void draw_messages(const Context& context) {
    draw_notices(context);
    draw_help(context);
}

void draw_panels(const Context& context) {
    if (context.purpose == Purpose::scene_still) return;
    if (context.state.scenes.open) {
        draw_scenes_page(context);
        draw_top_bar(context);
        return draw_messages(context);
    }
    draw_panel_tabs(context);
    draw_side_panel(context);
    draw_lesson_panel(context);
    draw_plots_panel(context);
    draw_time_line(context);
    draw_run_buttons(context);
    draw_edges(context);
    draw_top_bar(context);
    draw_pointed(context);
    draw_read_out(context);
    draw_hands(context);
    draw_lost_card(context);
    draw_divergence_card(context);
    draw_messages(context);
}

/// True if both are moments of the same runs.
bool same_runs(const SessionView& a, const SessionView& b) {
    return a.leading.run == b.leading.run && a.followers.size() == b.followers.size() &&
           a.playback.has_value() == b.playback.has_value() &&
           a.leading.frame.positions.size() == b.leading.frame.positions.size();
}

void set_style(render::Style& style, const RunView& view, const Selection& selection, const Display& display) {
    style.mass = view.frame.mass;
    style.selected = view.tracked ? std::optional(view.tracked->particle) : std::nullopt;
    style.selected_too = selection.others();
    style.pixel_scale = static_cast<double>(display.scale);
}

/// What a card has put on is of the run that it explains.
void end_oscillation_of_another_run(InterfaceState& state, std::uint64_t run) {
    if (!state.oscillation_of || *state.oscillation_of == run) return;
    state.oscillation_of.reset();
    state.oscillation = false;
}

/// By choice, or where a card explains a blow-up.
bool shows_oscillation(const SessionView& view, const InterfaceState& state) {
    const bool explained = view.blow_up && view.leading.divergence;
    return state.oscillation || (explained && state.dismissed_divergence != view.leading.divergence->step);
}

}  // namespace

Interface::Interface(const Display& display) : body_(std::make_unique<Body>(make_context(), display)) {}

Interface::~Interface() = default;

bool Interface::resize(const Display& display) {
    ImGui::SetCurrentContext(body_->context.get());
    body_->display = display;
    body_->display.scale = std::clamp(display.scale * static_cast<float>(body_->state.scale), least_scale, most_scale);
    const bool new_fonts = body_->display.scale != body_->theme.scale();
    if (new_fonts) body_->theme.apply(body_->display.scale);
    return new_fonts;
}

void Interface::clear() {
    Body& body = *body_;
    body.state = {};
    body.view_keeper = {};
    body.follower = {};
    body.trails = {};
    body.layout = {};
    body.widgets = {};
    body.frame_seconds.reset();
    body.new_view = true;
    body.input_left = false;
    body.unsettled = true;
}

void Interface::record(const RunView& view) {
    body_->state.history.record(view);
    body_->trails.record(view, body_->state.trail);
    body_->new_view = true;
}

bool Interface::show_doubt(const std::optional<Doubt>& doubt) {
    if (doubt == body_->state.doubt) return false;
    body_->state.doubt = doubt;
    return true;
}

Input& Interface::input() { return body_->input; }

void Interface::use_clipboard(Clipboard clipboard) {
    ImGui::SetCurrentContext(body_->context.get());
    body_->clipboard.clipboard = std::move(clipboard);
    ImGuiIO& io = ImGui::GetIO();
    io.ClipboardUserData = &body_->clipboard;
    io.GetClipboardTextFn = ImGuiClipboard::read;
    io.SetClipboardTextFn = ImGuiClipboard::write;
}

void Interface::draw(const SessionView& view, EventSink& events, Stage stage, const Measured& measured) {
    draw_frame(view, events, stage, measured, Purpose::use);
}

void Interface::draw_still(const SessionView& view, Stage stage, bool scene_alone,
                           const std::optional<Caption>& caption) {
    NoEvents no_events;
    const Purpose purpose = scene_alone ? Purpose::scene_still : Purpose::still;
    // ImGui knows the size of a window that fits its content only after drawing it once.
    for (int pass = 0; pass < 3; ++pass) draw_frame(view, no_events, stage, {}, purpose, caption);
}

void Interface::draw_picture(const SessionView& view, Stage stage) {
    NoEvents no_events;
    const Measured measured{.frame_seconds = body_->frame_seconds, .since_last_frame = 1e-6};
    ImGui::SetCurrentContext(body_->context.get());
    const PointerAway away(ImGui::GetIO());
    // What is on the screen stays where it is: the picture has places of its own.
    const WidgetMap on_screen = body_->widgets;
    const bool unsettled = body_->unsettled;
    for (int pass = 0; pass < 2; ++pass) draw_frame(view, no_events, stage, measured, Purpose::window_picture);
    leave_out_menus();
    body_->widgets = on_screen;
    body_->unsettled = unsettled;
}

PixelRect Interface::draw_plot_picture(const SessionView& view, Stage stage, const std::string& plot) {
    PlotsState& plots = body_->state.plots;
    const auto legends = plots.legends;
    plots.pictured = pictured_plot(plot, body_->layout.plots, body_->display);
    const PixelRect place = pixels(plots.pictured->area);
    draw_picture(view, stage);
    plots.pictured.reset();
    plots.legends = legends;
    return place;
}

void Interface::draw_frame(const SessionView& view, EventSink& events, Stage stage, const Measured& measured,
                           Purpose purpose, const std::optional<Caption>& caption) {
    Body& body = *body_;
    ImGui::SetCurrentContext(body.context.get());
    ImGuiIO& io = ImGui::GetIO();
    io.DisplaySize = size_of(body.display, body.state.plots.pictured);
    io.DeltaTime = static_cast<float>(measured.since_last_frame);
    body.theme.set_background(stage.style.background);
    body.frame_seconds = measured.frame_seconds;
    if (purpose == Purpose::use) body.input_left = body.input.feed(io);
    Input::steer(io, purpose == Purpose::use && body.state.steering && !io.WantTextInput);
    ImGui::NewFrame();
    const WidgetMap before = std::exchange(body.widgets, {});
    const bool is_new = std::exchange(body.new_view, false);
    body.state.wanted.follow(view.leading, is_new, view.playback.has_value());
    Display above = body.display;  // the caption
    if (caption) above.height -= caption_height(view, *caption);
    body.layout = purpose == Purpose::scene_still
                      ? arrange_scene_alone(above)
                      : arrange(above, body.state.panel, body.state.sizes, body.state.lessons.open.has_value(),
                                body.state.plots.shown.size());
    if (body.state.tab == PanelTab::plot) put_plots_into_panel(body.layout);
    const bool has_picture = stage.pictured && same_runs(*stage.pictured, view);
    const Context context{body.theme,   body.layout, above,  view,  has_picture ? *stage.pictured : view,
                          view.leading, measured,    events, stage, body.state,
                          body.widgets, purpose};
    if (purpose == Purpose::use) {
        body.view_keeper.keep(context);
        body.state.selection.follow(view.leading, is_new, events);
        body.follower.follow(context);
        leave_to_pointer(context);
        perform_pressed_keys(context);
        use_pointer(context);
    }
    set_style(stage.style, view.leading, body.state.selection, body.display);
    end_oscillation_of_another_run(body.state, view.leading.run);
    stage.style.oscillation =
        shows_oscillation(view, body.state) || (purpose == Purpose::still && stage.style.oscillation);
    stage.style.trails = body.state.trail ? body.trails.places() : nullptr;
    draw_panels(context);
    if (purpose == Purpose::use) draw_steering(context);
    if (caption) draw_caption(context, *caption, below(above, body.display));
    ImGui::Render();
    body.unsettled = body.widgets != before;
}

int Interface::caption_height(const SessionView& view, const Caption& caption) const {
    return static_cast<int>(ui::caption_height(body_->theme, caption, view));
}

void Interface::show_film(std::optional<FilmStatus> film) { body_->state.film = film; }

const std::string& Interface::focused() const {
    static const std::string none;
    return body_->state.steering ? body_->state.focused : none;
}

const PictureChoice& Interface::picture_choice() const { return body_->state.picture; }

render::Following Interface::following() const { return body_->state.following; }

bool Interface::is_dragging() const {
    ImGui::SetCurrentContext(body_->context.get());
    const bool held = ImGui::IsAnyItemActive() || body_->state.hands.pulled;
    return body_->state.hands.by_keys || (held && ImGui::IsMouseDragging(ImGuiMouseButton_Left));
}

bool Interface::shows_plots() const { return !body_->layout.plots.empty(); }

PixelRect Interface::scene() const { return pixels(body_->layout.scene); }

ImDrawData& Interface::draw_data() const {
    ImGui::SetCurrentContext(body_->context.get());
    return *ImGui::GetDrawData();
}

ImFontAtlas& Interface::fonts() const {
    ImGui::SetCurrentContext(body_->context.get());
    return *ImGui::GetIO().Fonts;
}

ImGuiContext& Interface::context() const { return *body_->context; }

std::vector<Request> Interface::take_requests() { return std::exchange(body_->state.requests, {}); }

double Interface::seconds_until_change() const {
    ImGui::SetCurrentContext(body_->context.get());
    if (body_->input_left || body_->unsettled) return 0;
    const auto& notice = body_->state.notice;
    return notice ? std::max(0.0, notice->until - ImGui::GetTime()) : std::numeric_limits<double>::infinity();
}

void Interface::notify(std::string text) {
    ImGui::SetCurrentContext(body_->context.get());
    body_->state.notice = Notice{std::move(text), ImGui::GetTime() + 4};
}

void Interface::notify_saved(const std::string& file) {
    ImGui::SetCurrentContext(body_->context.get());
    body_->state.notice = notice_of_saved(file);
}

void Interface::report_error(std::string text) {
    body_->state.scenes.opening.reset();
    body_->state.wanted.refuse(std::move(text));
}

const WidgetMap& Interface::widgets() const { return body_->widgets; }

}  // namespace steplab::ui
