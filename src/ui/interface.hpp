#pragma once

#include "session/lesson.hpp"
#include "session/worker.hpp"
#include "ui/caption.hpp"
#include "ui/context.hpp"
#include "ui/display.hpp"
#include "ui/gallery.hpp"
#include "ui/input.hpp"

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

struct ImDrawData;
struct ImFontAtlas;
struct ImGuiContext;

namespace steplab::ui {

/// The clipboard shared with other programs.
struct Clipboard {
    std::function<std::string()> read;
    std::function<void(const std::string& text)> write;
};

/// All panels of a window or a snapshot. It owns an ImGui context and no OpenGL object; the caller draws draw_data()
/// with the glyphs of fonts(). All positions are pixels from the top left of the display.
///
/// A snapshot with panels (`snapshot --ui on`):
///     ui::Interface interface({.width = 1280, .height = 720});
///     for (const RunView& earlier : recorded) interface.record(earlier);   // for the plots; optional
///     interface.draw_still({.leading = view_of(simulation)}, {camera, style});
///     // draw the scene into interface.scene(), then interface.draw_data() over the whole picture
class Interface {
public:
    explicit Interface(const Display& display);
    ~Interface();
    Interface(const Interface&) = delete;
    Interface& operator=(const Interface&) = delete;

    /// Sets the size and scale of the display. True if the fonts were rebuilt: their texture must then be rebuilt, too.
    bool resize(const Display& display);
    /// As newly made, but for its fonts: for another snapshot.
    void clear();
    /// Records a new view of the run for the plots. Call it once for each view, before drawing it.
    void record(const RunView& view);
    /// Says that the run's energy is impossible and where that is decided, in place of a card about the divergence.
    /// True if that is news.
    bool show_doubt(const std::optional<Doubt>& doubt);
    /// Before the first frame: whether the panel is shown, and the particle that is selected; none: as usual. `scenes`:
    /// the page of scenes is open.
    void open_with(std::optional<bool> panel, std::optional<std::size_t> particle, bool scenes = false);
    /// True if the last frame had room for plots.
    bool shows_plots() const;
    /// The particles that are selected besides that one.
    void select_too(const ParticleList& others);
    /// What a person chose before, but for what the style says; `remembered`: with which the next window opens.
    void use(const ViewChoices& choices, const ViewChoices& remembered);
    /// What a person chose by now. What the file of a scene chose in the style is left out.
    ViewChoices choices(const render::Style& style) const;
    /// The surface with the scale that the person chose.
    const Display& display() const;
    /// True while the page of scenes covers the scene.
    bool shows_scenes() const;
    /// What the page of scenes offers; until the first call: the models, without pictures.
    void show_gallery(Gallery gallery);
    /// The lessons that it offers.
    void show_lessons(std::vector<LessonTitle> titles);
    /// Opens a lesson at its first page, in place of another one. Closes the page of scenes.
    void open_lesson(Lesson lesson);
    /// The lesson that is open and its page, counted from 1: "one-step 2"; empty if none is.
    std::string lesson() const;
    /// Shows a scene that was read as the user asked. Closes the page of scenes.
    void open(const RunDescription& scene, EventSink& events);
    /// Closes the page of scenes: something else was opened.
    void close_scenes();
    /// Shows a scene that was read again because its file changed, unless another one is shown by now.
    void reload(const RunDescription& scene, EventSink& events);
    /// Takes events of keyboard and mouse for the next frames.
    Input& input();
    /// The clipboard for text entries; without one, copied text stays within the interface.
    void use_clipboard(Clipboard clipboard);
    /// Draws one frame: sends the user's events to `events`, moves the camera and sets the style.
    void draw(const SessionView& view, EventSink& events, Stage stage, const Measured& measured = {});
    /// Draws a frame without input: the same view always gives the same draw data. A scene alone fills the display; a
    /// caption takes the foot of it.
    void draw_still(const SessionView& view, Stage stage, bool scene_alone = false,
                    const std::optional<Caption>& caption = std::nullopt);
    /// Draws what the window shows as a picture is to show it: without pointer, tooltip, notice and open menu. The next
    /// draw() goes on as if nothing had been.
    void draw_picture(const SessionView& view, Stage stage);
    /// The same, and beside it a plot of this name, large enough for all that is written in it: the place of that.
    PixelRect draw_plot_picture(const SessionView& view, Stage stage, const std::string& plot);

    /// How much of a still its caption takes, in pixels.
    int caption_height(const SessionView& view, const Caption& caption) const;
    /// What is known of the film that is taken; none: no film is.
    void show_film(std::optional<FilmStatus> film);
    /// The widget that the keyboard is at; empty if it goes to none.
    const std::string& focused() const;
    /// What pictures and films show.
    const PictureChoice& picture_choice() const;

    /// What the camera goes with.
    render::Following following() const;
    /// True while the pointer draws a slider, the time line or a particle along, or keys pull one: the picture is to
    /// follow it.
    bool is_dragging() const;
    /// The area of the scene in the last frame.
    PixelRect scene() const;
    /// The draw data of the last frame; valid until the next one.
    ImDrawData& draw_data() const;
    ImFontAtlas& fonts() const;
    ImGuiContext& context() const;

    /// The requests to the program since the last call.
    std::vector<Request> take_requests();
    /// Seconds until the picture changes without input: 0 if another frame is needed at once, infinity if it does not
    /// change.
    double seconds_until_change() const;
    /// Shows `text` over the scene for some seconds.
    void notify(std::string text);
    /// Shows for some seconds that a file was saved: its whole path, which a click copies.
    void notify_saved(const std::string& file);
    /// Shows an error message until it is closed.
    void report_error(std::string text);
    /// The places of the widgets in the last frame, by name; for tests.
    const WidgetMap& widgets() const;

private:
    struct Body;
    void draw_frame(const SessionView& view, EventSink& events, Stage stage, const Measured& measured, Purpose purpose,
                    const std::optional<Caption>& caption = std::nullopt);

    std::unique_ptr<Body> body_;
};

}  // namespace steplab::ui
