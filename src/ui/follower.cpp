#include "ui/follower.hpp"

namespace steplab::ui {

void Follower::follow(const Context& context) {
    const RunView& view = context.view;
    if (!view.frame.shape) return;
    const auto selected = view.tracked ? std::optional(view.tracked->particle) : std::nullopt;
    const Kind kind{context.state.following, selected, view.run, view.frame.shape};
    if (kind == kind_ && step_ == view.frame.step) return;
    const auto point = render::followed_point(view.frame, kind.following, selected);
    const bool goes_on = kind == kind_ && last_ && point;
    render::Camera& camera = context.stage.camera;
    if (goes_on) camera.focus = camera.focus + (*point - *last_);
    kind_ = kind;
    step_ = view.frame.step;
    last_ = point;
}

}  // namespace steplab::ui
