#pragma once

#include "app/cli/appearance_options.hpp"
#include "app/cli/ensemble_options.hpp"
#include "app/cli/picture_content_options.hpp"
#include "app/cli/scene_options.hpp"
#include "app/cli/session_option.hpp"
#include "app/cli/shown_runs_options.hpp"
#include "render/style.hpp"
#include "session/run_view.hpp"
#include "ui/view_choices.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace steplab {

/// What the window opens with, beside the run's description.
struct WindowRequest {
    int width = 1280;  ///< pixels
    int height = 800;
    std::optional<float> scale;  ///< pixels per unit of the layout; none: the display's
    std::string view;            ///< camera as text; empty: the scene's own
    render::Style style;         ///< with the particle to select, if there is one
    std::optional<bool> panel;   ///< shown or not; none: where the window has room
    std::uint64_t steps = 0;     ///< that the run takes before anything else
    std::optional<Rate> rate;    ///< none: the usual one
    LiveEnsembleOptions ensemble;
    std::vector<RunDescription> followers = {};  ///< runs beside it
    GivenSession session;
    ui::ViewChoices choices = {};     ///< what else a person chose before
    ui::ViewChoices remembered = {};  ///< the same, whatever the command line says
    std::string config = {};          ///< where choices are remembered; empty: the user's own file, "none": nowhere
    std::string note = {};            ///< that the window shows when it opens, as why nothing was remembered
    std::string trace;                ///< file to which events are written; empty: none
    bool scenes = false;              ///< the page of scenes is open
    bool full_screen = false;
    bool playing = false;  ///< after these steps
};

/// The options of `steplab view` and `steplab-view` that are not the scene's.
class ViewOptions {
public:
    void declare(CLI::App& app);
    /// The runs of the scene, the leading one first. Throws UsageError.
    std::vector<RunDescription> runs(const RunDescription& scene) const { return runs_.runs(scene); }
    /// Throws UsageError for values of another form or out of range.
    WindowRequest request(const std::vector<RunDescription>& runs, GivenSession session = {}) const;
    /// Puts what a person chose before into the request of a window, where the command line does not say it.
    void put_remembered(const ui::ViewChoices& choices, const RunDescription& description,
                        WindowRequest& request) const;
    /// Throws as SessionOption does.
    GivenSession session(const SceneOptions& scene) const { return session_.session(scene); }
    /// Where the window opens beyond --until, as it takes whole steps.
    std::optional<std::string> note(const RunDescription& description) const {
        return time_.note(description, {time_.steps(description)});
    }

private:
    /// Throws UsageError for options that say nothing of what is played.
    void check_beside(const GivenSession& session) const;

    TimeOptions time_{0};
    AppearanceOptions appearance_;
    PictureContentOptions content_;
    EnsembleOptions ensemble_;
    ShownRunsOptions runs_;
    SessionOption session_;
    const CLI::App* app_ = nullptr;
    std::string config_;
    std::string size_ = "1280x800";
    std::string speed_;
    std::string trail_;
    std::string trace_;
    bool full_screen_ = false;
    bool playing_ = false;
};

}  // namespace steplab
