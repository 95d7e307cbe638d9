#pragma once

#include "core/vec3.hpp"
#include "render/camera.hpp"
#include "render/following.hpp"
#include "render/known_shape.hpp"
#include "render/style.hpp"
#include "session/lesson.hpp"
#include "session/share.hpp"
#include "session/worker.hpp"
#include "ui/display.hpp"
#include "ui/gallery.hpp"
#include "ui/plot/choice.hpp"
#include "ui/plot/history.hpp"
#include "ui/replaced.hpp"
#include "ui/selection.hpp"
#include "ui/view_choices.hpp"
#include "ui/wanted.hpp"
#include "ui/widgets/layout.hpp"
#include "ui/widgets/theme.hpp"

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace steplab::ui {

/// The camera and the style of the drawing, which the interface reads and changes.
struct Stage {
    render::Camera& camera;
    render::Style& style;
    const SessionView* pictured = nullptr;  ///< what the picture that is shown was drawn from; null: the view itself
};

/// An open text entry in place of a slider: its widget and the text so far.
struct Entry {
    std::string widget;
    std::array<char, 64> text{};
    bool just_opened = false;
};

/// A short message over the scene, shown for some seconds.
struct Notice {
    std::string text;
    double until = 0;       ///< on the interface's clock, in seconds
    std::string copy = {};  ///< what a click on it copies; empty: nothing
};
/// The notice that a file was saved, with its whole path.
Notice notice_of_saved(const std::string& file);

/// A particle that keys pull, and the place that it is to be seen at.
struct KeyPull {
    std::size_t particle = 0;
    Vec3 place;
};

/// What the pointer does with particles.
struct Hands {
    std::optional<std::size_t> pulled;       ///< the particle that follows the pointer
    std::optional<KeyPull> by_keys;          ///< while the keys of a pull are held
    bool moved = false;                      ///< the pointer has, since that was taken hold of
    std::optional<std::uint64_t> tugged_at;  ///< the step seen at the last tug of the present hold
    std::optional<std::uint64_t> pulled_in;  ///< the last run in which something was done to a particle
    std::optional<std::size_t> kicked;       ///< the particle at which an arrow begins
    Vec3 kick;                               ///< what the arrow says [m/s]
    std::optional<render::PixelPoint>
        box_from;                              ///< a corner of the box that is drawn, in the picture of the leading run
    bool selecting = false;                    ///< the next drag draws a box
    std::array<char, 64> velocity{"0, 0, 0"};  ///< of a kick, as typed
};

/// The page of scenes, which covers all but the bar while it is open.
struct ScenesPage {
    bool open = false;
    bool to_type = false;  ///< it was opened to type a path
    bool lessons = false;  ///< it lists the lessons in place of the scenes
    Gallery gallery = model_gallery();
    std::array<char, 4096> path{};       ///< typed so far
    std::optional<std::string> opening;  ///< a scene that is being read
};

/// The guided experiments.
struct LessonsState {
    std::vector<LessonTitle> titles = {};   ///< that can be opened
    std::optional<Lesson> open = {};        ///< in the panel
    std::size_t page = 0;                   ///< of it, that is shown
    std::optional<std::size_t> begun = {};  ///< the page whose part was played last
    Replaced<std::vector<PlotChoice>> plots = {};
    Replaced<Rate> rate = {};
};

/// What the side panel shows of its sections in a window too low for all of them.
enum class PanelTab { scene, runs, method, display, state, plot };

/// State that the interface keeps from frame to frame.
struct InterfaceState {
    Wanted wanted;
    History history;
    PlotsState plots;
    std::optional<Entry> entry;
    std::optional<Notice> notice;
    std::optional<render::KnownShape> shape;  ///< of the newest frame
    std::optional<bool> panel;                ///< chosen by the user; none: shown where the window has room
    double scale = 1;                         ///< of the interface, beside that of the display
    PanelSizes sizes;
    PanelTab tab = PanelTab::scene;
    PictureChoice picture;
    bool steering = false;                      ///< the keyboard goes from widget to widget
    std::string steered;                        ///< the panel that it is in
    std::string focused;                        ///< the widget that it is at
    bool to_reveal = false;                     ///< its panel was entered, and is scrolled to where the widget is
    std::optional<FilmStatus> film;             ///< that is taken
    ViewChoices remembered;                     ///< with which a window opens that is told nothing else
    std::optional<std::size_t> first_selected;  ///< the particle to select first; none: the usual one
    render::Following following = render::Following::nothing;
    bool oscillation = false;                          ///< the fastest one of the scene as it is now is drawn
    std::optional<std::uint64_t> oscillation_of = {};  ///< the run of which a card has put it on
    bool trail = false;  ///< of the selected particle, and of those selected meanwhile, is drawn
    bool help_open = false;
    ScenesPage scenes;
    LessonsState lessons;
    std::optional<std::size_t> pointed;  ///< the particle under the pointer, which a click selects
    Share pointing{0.05};                ///< searching for it: in a large scene that takes long
    Selection selection;
    Hands hands;
    bool drag_from_scene = false;                      ///< the left or right button was pressed over the scene
    bool dragged = false;                              ///< the pointer has moved since then: not a click
    std::optional<std::size_t> dismissed_divergence;   ///< step of the divergence whose card was closed
    std::size_t card_corner = 0;                       ///< of the scene, in which that card stands
    std::optional<event::Play> plays_after_scrubbing;  ///< while the time line is dragged
    std::optional<Doubt> doubt;                        ///< why the picture stands still
    bool lost = false;                                 ///< no particle is in view
    bool dismissed_lost = false;                       ///< the card about it was closed
    std::vector<Request> requests;
};

/// Everything a panel needs to draw one frame.
struct Context {
    const Theme& theme;
    const Layout& layout;
    const Display& display;
    const SessionView& session;
    /// What the picture of the scene shows: `session`, or where the picture takes long the moment before it.
    const SessionView& pictured;
    const RunView& view;  ///< of the leading run
    const Measured& measured;
    EventSink& events;
    Stage stage;
    InterfaceState& state;
    WidgetMap& widgets;
    Purpose purpose = Purpose::use;

    /// A run of the session, the leading one being number 0.
    const RunView& run(std::size_t number) const { return number == 0 ? view : session.followers[number - 1]; }
    float px(float units) const { return theme.px(units); }
    /// The sizes at which the particles of the view are drawn.
    const render::DrawnSizes& sizes() const;
    /// The areas of the runs in that of the scene, which have the same camera: all of it, or a tile each.
    std::vector<PixelRect> tiles() const;
    /// The area of the leading run.
    PixelRect tile() const { return tiles().front(); }
    /// The camera and the area of the leading run.
    render::Projection projection() const;
    /// True in a picture of the window, which has nothing of the pointer and nothing that passes.
    bool is_saved() const { return purpose == Purpose::window_picture; }
    /// The run description that the panels show and change.
    const RunDescription& description() const { return state.wanted.description(); }
    void ask(const RunDescription& description) const { state.wanted.ask(description, events); }
    void request(Request request) const { state.requests.push_back(std::move(request)); }
    /// Records the place of the widget that was drawn last.
    void mark(std::string_view widget) const;
    void mark(std::string_view widget, const WidgetRect& place) const;
    /// Notes that the keyboard is at the widget that was drawn last, if it is.
    void note_focus(std::string_view widget) const;
};

}  // namespace steplab::ui
