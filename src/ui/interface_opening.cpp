// What an interface opens with, and what is opened in it: choices, scenes, lessons.

#include "sim/run/opening.hpp"
#include "ui/interface_body.hpp"

#include <string>
#include <utility>

namespace steplab::ui {

void Interface::open_with(std::optional<bool> panel, std::optional<std::size_t> particle, bool scenes) {
    body_->state.panel = panel;
    body_->state.first_selected = particle;
    body_->state.scenes.open = scenes;
}

void Interface::select_too(const ParticleList& others) { body_->state.selection = Selection(others); }

void Interface::use(const ViewChoices& choices, const ViewChoices& remembered) {
    InterfaceState& state = body_->state;
    state.scale = choices.scale;
    state.panel = choices.panel;
    state.sizes = choices.sizes;
    state.trail = choices.trail;
    state.plots.shown = choices.plots;
    state.picture = choices.picture;
    state.remembered = remembered;
}

ViewChoices Interface::choices(const render::Style& style) const {
    const InterfaceState& state = body_->state;
    ViewChoices choices{.scale = state.scale,
                        .background = body_->view_keeper.own(style.background),
                        .colouring = body_->view_keeper.own(style.colouring),
                        .springs = style.springs,
                        .grid = style.grid,
                        .trail = state.trail,
                        .velocities = style.velocities,
                        .forces = style.forces,
                        .panel = state.panel,
                        .sizes = state.sizes,
                        .plots = state.lessons.plots.own(state.plots.shown),
                        .picture = state.picture};
    choices.width = state.remembered.width;
    choices.height = state.remembered.height;
    return choices;
}

const Display& Interface::display() const { return body_->display; }

bool Interface::shows_scenes() const { return body_->state.scenes.open; }

void Interface::show_gallery(Gallery gallery) { body_->state.scenes.gallery = std::move(gallery); }

void Interface::show_lessons(std::vector<LessonTitle> titles) { body_->state.lessons.titles = std::move(titles); }

void Interface::open_lesson(Lesson lesson) {
    close_scenes();
    LessonsState& lessons = body_->state.lessons;
    lessons.open = std::move(lesson);
    lessons.page = 0;
    lessons.begun.reset();
}

std::string Interface::lesson() const {
    const LessonsState& lessons = body_->state.lessons;
    return lessons.open ? lessons.open->id + ' ' + std::to_string(lessons.page + 1) : "";
}

void Interface::open(const RunDescription& scene, EventSink& events) {
    InterfaceState& state = body_->state;
    state.scenes.opening.reset();
    state.wanted.dismiss();
    state.wanted.ask(scene, events);
    state.scenes.open = state.scenes.open && !state.wanted.message().empty();
}

void Interface::close_scenes() {
    body_->state.scenes.opening.reset();
    body_->state.scenes.open = false;
    body_->state.wanted.dismiss();
}

void Interface::reload(const RunDescription& scene, EventSink& events) {
    Wanted& wanted = body_->state.wanted;
    if (!wanted.description().origin || id_of(wanted.description()) != id_of(scene)) return;
    wanted.dismiss();
    wanted.ask(reloaded(wanted.description(), scene), events);
}

}  // namespace steplab::ui
