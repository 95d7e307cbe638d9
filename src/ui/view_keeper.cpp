#include "ui/view_keeper.hpp"

#include "ui/actions.hpp"

#include <algorithm>

namespace steplab::ui {

void ViewKeeper::keep(const Context& context) {
    const RunView& view = context.view;
    if (!view.frame.shape) return;
    const PixelRect place = pixels(context.layout.scene);
    const bool first = !shape_;
    const bool other_model = model_ != view.description.model;
    const bool other_shape = shape_ != view.frame.shape;
    const std::size_t particles = view.frame.shape->roles.size();
    if (first ? !view.tracked : other_model || (other_shape && shape_->roles.size() != particles)) {
        const std::size_t usual = first_followed(*view.frame.shape);
        context.commands.track(first ? context.session.first_selected.value_or(usual) : usual);
    }
    // The command line may have set the camera; one that is still untouched is placed where the scene opens.
    const bool untouched = context.stage.camera == home_.value_or(render::Camera{});
    const bool moved_about = other_shape || place != place_;
    if ((first && untouched) || (!first && (other_model || (moved_about && untouched)))) {
        reset_view(context);
        home_ = context.stage.camera;
    }
    model_ = view.description.model;
    shape_ = view.frame.shape;
    place_ = place;
}

}  // namespace steplab::ui
