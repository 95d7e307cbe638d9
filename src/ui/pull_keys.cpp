#include "ui/pull_keys.hpp"

#include "render/bounds.hpp"
#include "ui/hands.hpp"
#include "ui/input.hpp"

namespace steplab::ui {
namespace {

/// A key moves the place by so many units of the layout.
constexpr float key_pull = 6, key_long_pull = 30;

bool has_keys(const Context& context) {
    const ImGuiIO& io = ImGui::GetIO();
    const InterfaceState& state = context.state;
    return io.KeyCtrl && !io.KeyAlt && !io.WantTextInput && !state.steering && !state.scenes.open &&
           !state.hands.pulled;
}

/// Of the selected particle, where it is seen; nothing if there is none.
std::optional<KeyPull> pull_begun(const Context& context) {
    const auto& tracked = context.view.tracked;
    const Frame& frame = context.view.frame;
    if (!tracked || tracked->particle >= frame.positions.size()) return std::nullopt;
    const Vec3 seen = frame.seen(tracked->particle);
    if (!render::drawable(seen)) return std::nullopt;
    return KeyPull{tracked->particle, seen};
}

bool is_of_the_selected(const KeyPull& pull, const Context& context) {
    const auto& tracked = context.view.tracked;
    return tracked && tracked->particle == pull.particle && pull.particle < context.view.frame.positions.size();
}

/// The place moved in the picture by so many keys to the right and down.
Vec3 moved_by_keys(const Context& context, Vec3 place, int right, int down) {
    const render::Projection projection = context.projection();
    const auto pixel = projection.pixel(place);
    if (!pixel) return place;
    const auto step = static_cast<double>(context.px(ImGui::GetIO().KeyShift ? key_long_pull : key_pull));
    return beside(place, {pixel->x + right * step, pixel->y + down * step}, projection);
}

}  // namespace

bool use_pull_keys(const Context& context) {
    Hands& hands = context.state.hands;
    if (hands.by_keys && (!has_keys(context) || !is_of_the_selected(*hands.by_keys, context))) hands.by_keys.reset();
    if (!has_keys(context)) return false;
    const int right = presses(Key::right, Key::left), down = presses(Key::down, Key::up);
    const bool pressed = right != 0 || down != 0;
    if (pressed && !hands.by_keys) {
        hands.by_keys = pull_begun(context);
        hands.tugged_at.reset();
    }
    if (!hands.by_keys) return pressed;
    Vec3& place = hands.by_keys->place;
    if (pressed) place = moved_by_keys(context, place, right, down);
    if (pressed || context.view.playing) pull_to(context, hands.by_keys->particle, place);
    return pressed;
}

}  // namespace steplab::ui
