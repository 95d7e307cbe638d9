#include "render/picking.hpp"
#include "ui/actions.hpp"
#include "ui/panels/panels.hpp"
#include "ui/widgets/cards.hpp"
#include "ui/widgets/widgets.hpp"

namespace steplab::ui {

void draw_lost_card(const Context& context) {
    const Area& scene = context.layout.scene;
    InterfaceState& state = context.state;
    state.lost = !render::any_in_view(context.view.frame, context.sizes(), context.projection());
    if (!state.lost) state.dismissed_lost = false;
    if (!state.lost || state.dismissed_lost) return;
    const ImVec2 anchor{scene.x + 0.5f * scene.width, scene.y + 0.72f * scene.height};
    const Card card(context, "lost", anchor, {0.5f, 0.5f}, card_width(context, 300), colour::line);
    ImGui::TextWrapped("No particle is in view.");
    ImGui::Dummy({0, context.px(4)});
    if (text_button(context, "lost.fit", "Zoom to fit (F)", true)) perform(context, Action::zoom_to_fit);
}

}  // namespace steplab::ui
