#include "ui/view_keeper.hpp"

#include "ui/actions.hpp"

#include <algorithm>

namespace steplab::ui {

void ViewKeeper::keep(const Context& context) {
    const RunView& view = context.view;
    if (!view.frame.shape) return;
    const bool first = !shape_;
    const bool other_scene = scene_ != id_of(view.description);
    const bool other_shape = shape_ != view.frame.shape;
    const std::size_t particles = view.frame.shape->roles.size();
    if (first ? !view.tracked : other_scene || (other_shape && shape_->roles.size() != particles)) {
        const std::size_t usual = first_followed(*view.frame.shape);
        if (!first) context.state.selection.clear();
        context.events.send(event::Track{first ? context.state.first_selected.value_or(usual) : usual});
    }
    place_camera(context, first, other_scene, other_shape);
    if (first || other_scene) choose_colours(context, first);
    if (!first && other_scene && context.stage.style.displacements != 1) magnify(context, 1);
    scene_ = id_of(view.description);
    origin_ = view.description.origin;
    shape_ = view.frame.shape;
    place_ = context.tile();
}

/// The command line may have set the camera; one that is still untouched is placed where the scene opens.
void ViewKeeper::place_camera(const Context& context, bool first, bool other_scene, bool other_shape) {
    const bool untouched = context.stage.camera == home_.value_or(render::Camera{});
    const bool read_again = !first && !other_scene && origin_ != context.view.description.origin;
    const bool moved_about = (other_shape && !read_again) || context.tile() != place_;
    if (!(first ? untouched : other_scene || (moved_about && untouched))) return;
    reset_view(context);
    home_ = context.stage.camera;
}

void ViewKeeper::choose_colours(const Context& context, bool first) {
    const SceneOrigin& origin = context.view.description.origin;
    std::optional<render::Colouring> colouring;
    std::optional<render::Background> background;
    if (origin && !origin->defaults.colour.empty()) colouring = colouring_of(origin->defaults.colour);
    if (origin && !origin->defaults.background.empty()) background = background_of(origin->defaults.background);
    colouring_.follow(context.stage.style.colouring, colouring, first, context.state.remembered.colouring);
    background_.follow(context.stage.style.background, background, first, context.state.remembered.background);
}

}  // namespace steplab::ui
