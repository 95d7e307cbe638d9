// How a window opens, and what it remembers of how a person left it.
#include "app/cli/standard_streams.hpp"
#include "app/cli/view_choices_file.hpp"
#include "app/window/viewer.hpp"
#include "core/error.hpp"
#include "render/framing.hpp"
#include "render/split.hpp"

#include <fmt/format.h>

#include <tuple>
#include <utility>

namespace steplab {

/// Asks the run for the moment to open at, and shows it from its start until then.
void Viewer::open(const WindowRequest& request) {
    style_ = request.style;
    interface_.open_with(request.panel, request.style.selected, request.scenes);
    interface_.select_too(request.style.selected_too);
    interface_.use(request.choices, request.remembered);
    choices_file_ = view_choices_path(request.config);
    if (!request.note.empty()) interface_.report_error(request.note);
    interface_.resize(window_.display());
    picture_.upload_fonts(interface_.fonts());
    if (style_.forces) worker_->send(event::ShowForces{true});
    if (style_.displacements != 1) worker_->send(event::Magnify{style_.displacements});
    take_news();
    place_camera(request);  // a wrong text is reported now
    for (const RunDescription& run : request.followers) worker_->send(event::AddRun{run, true});
    if (request.rate) worker_->send(event::SetRate{*request.rate});
    if (request.ensemble.runs > 0) worker_->send(event::ShowEnsemble{request.ensemble});
    if (request.steps > 0) worker_->send(event::Seek{request.steps});
    if (request.session.film) tell_of_film();
    if (request.session.lesson) interface_.open_lesson(*request.session.lesson);
    opening_ = request;
    begin_as_asked();
}

void Viewer::place_camera(const WindowRequest& request) {
    const ui::PixelRect scene =
        ui::pixels(ui::arrange(interface_.display(), request.panel, request.choices.sizes).scene);
    if (request.view.empty()) return;
    const auto size = render::leading_size({scene.width, scene.height}, style_.layout, 1 + request.followers.size());
    camera_ = render::camera_of(request.view, view_->leading.frame, size);
}

/// Once the run is at the moment to open at, on which the camera may depend.
void Viewer::begin_as_asked() {
    if (!opening_) return;
    const bool was_under_way = std::exchange(under_way_, view_->leading.goal.has_value());
    const bool at_goal = view_->playback || view_->leading.frame.step >= opening_->steps || view_->leading.divergence ||
                         !view_->leading.error.empty();
    if (!at_goal && !was_under_way) return;                // it has not set out yet
    if (!at_goal && !under_way_) return opening_.reset();  // a person wanted something else
    if (!at_goal) return;
    place_camera(*opening_);
    if (opening_->playing) worker_->send(event::Play{true});
    opening_.reset();
}

ui::ViewChoices Viewer::choices() const {
    ui::ViewChoices choices = interface_.choices(style_);
    if (opened_choices_)
        std::tie(choices.width, choices.height) = std::pair(opened_choices_->width, opened_choices_->height);
    if (const auto size = window_.size()) std::tie(choices.width, choices.height) = *size;
    return choices;
}

/// For the next window. That a window cannot remember is no fault of what was done in it.
void Viewer::remember_choices() const {
    if (!opened_choices_) return;
    try {
        remember_view_choices(choices_file_, *opened_choices_, choices());
    } catch (const Error& error) {
        print_note("steplab-view", fmt::format("what was chosen is not remembered: {}", error.what()));
    }
}

}  // namespace steplab
