#include "ui/size_keys.hpp"

#include "ui/input.hpp"

#include <algorithm>

namespace steplab::ui {
namespace {

/// A key moves an edge by so many units of the layout.
constexpr double key_size = 20;

/// The wanted width may be more than a narrow window gives: the edge moves from where it is seen.
void widen_panel(const Context& context, int steps) {
    const double shown = static_cast<double>(context.layout.panel.width / context.theme.scale());
    context.state.sizes.panel_width =
        std::clamp(shown + steps * key_size, PanelSizes::least_width, PanelSizes::most_width);
}

void raise_plots(const Context& context, int steps) {
    const double shown = static_cast<double>(context.layout.plots.height / context.theme.scale());
    context.state.sizes.plots_height =
        std::clamp(shown + steps * key_size, PanelSizes::least_height, PanelSizes::most_height);
}

}  // namespace

bool use_size_keys(const Context& context) {
    const ImGuiIO& io = ImGui::GetIO();
    const InterfaceState& state = context.state;
    if (!io.KeyShift || io.KeyCtrl || io.KeyAlt || io.WantTextInput || state.steering || state.scenes.open)
        return false;
    const int wider = presses(Key::right, Key::left), higher = presses(Key::up, Key::down);
    const bool usual = Input::pressed(Key::home, false);
    const Layout& layout = context.layout;
    if (wider != 0 && !layout.panel.empty()) widen_panel(context, wider);
    if (higher != 0 && !layout.plots.empty() && !layout.plots_in_panel) raise_plots(context, higher);
    if (usual) context.state.sizes = {};
    return wider != 0 || higher != 0 || usual;
}

}  // namespace steplab::ui
