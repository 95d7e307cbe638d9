#include "ui/hands.hpp"

#include "render/bounds.hpp"
#include "render/picking.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace steplab::ui {
namespace {

/// A particle that is pulled while the run plays comes to the pointer within some 0.3 s of the wall clock: angular
/// frequency of the spring there [1/s].
constexpr double pull_rate = 13;

bool went_down(int button) { return ImGui::GetIO().MouseClicked[button]; }

/// The pointer in the picture of the leading run.
render::PixelPoint pointer_place(const Context& context) {
    const ImVec2 pointer = ImGui::GetIO().MousePos;
    const PixelRect tile = context.tile();
    return {static_cast<double>(pointer.x) - tile.x, static_cast<double>(pointer.y) - tile.y};
}

Vec3 under_pointer_beside(Vec3 place, const Context& context, const render::Projection& projection) {
    return beside(place, pointer_place(context), projection);
}

/// Simulated seconds that pass in one of the wall clock.
double speed_of(const Context& context) {
    const RunView& view = context.view;
    const double wanted = context.state.wanted.rate().seconds_per_second;
    const double measured = view.steps_per_second.value_or(0) * std::abs(view.dt);
    const bool unlimited = context.state.wanted.rate().as_fast_as_possible;
    if (measured > 0) return unlimited ? measured : std::min(measured, wanted);
    return unlimited ? 1 : wanted;
}

/// But no weaker than what holds the particle elsewhere.
double tug_rate(const Context& context) {
    const auto& limit = context.view.limit;
    return std::max(pull_rate / speed_of(context), limit ? 2 * limit->omega_max : 0);
}

/// What goes with a particle that is taken hold of: the other selected ones, if it is one of them.
ParticleList others_with(std::size_t particle, const Context& context) {
    const Selection& selection = context.state.selection;
    if (!selection.contains(particle, context.view)) return {};
    std::vector<std::size_t> others = selection.all(context.view);
    std::erase_if(others, [&](std::size_t other) {
        return other == particle || context.view.frame.shape->roles[other] == Role::fixed;
    });
    return ParticleList(std::move(others));
}

/// Where a particle is to go that was seen at one place and is to be seen at another.
Vec3 position_seen_at(const Frame& frame, std::size_t particle, Vec3 place) {
    const Vec3 image = frame.drawn(particle) - frame.seen(particle);
    return frame.position_drawn_at(particle, place + image);
}

/// Once for each step that is seen: between, no time has passed for the spring.
void tug(const Context& context, std::size_t particle, Vec3 place) {
    Hands& hands = context.state.hands;
    const Frame& frame = context.view.frame;
    if (hands.tugged_at == frame.step) return;
    context.events.send(event::Do{Tug{particle, position_seen_at(frame, particle, place), tug_rate(context),
                                      hands.tugged_at.has_value(), others_with(particle, context)}});
    hands.tugged_at = frame.step;
}

void pull(const Context& context, const render::Projection& projection) {
    const ImGuiIO& io = ImGui::GetIO();
    Hands& hands = context.state.hands;
    const std::size_t particle = *hands.pulled;
    if (!io.MouseDown[0] || particle >= context.view.frame.positions.size()) {
        hands.pulled.reset();
        return;
    }
    const Vec3 seen = context.view.frame.seen(particle);
    if (!render::drawable(seen)) return;
    const Vec3 place = under_pointer_beside(seen, context, projection);
    hands.moved = hands.moved || io.MouseDelta.x != 0 || io.MouseDelta.y != 0;
    const bool moves = io.MouseDelta.x != 0 || io.MouseDelta.y != 0;
    if (context.view.playing ? hands.moved : moves) pull_to(context, particle, place);
}

bool is_dragged(const Context& context, int button) {
    const float tolerance = context.px(4);
    return ImGui::GetIO().MouseDragMaxDistanceSqr[button] >= tolerance * tolerance;
}

/// The arrow ends where the kick alone would take the particle within a second of the wall clock.
void aim(const Context& context, const render::Projection& projection) {
    Hands& hands = context.state.hands;
    const Frame& frame = context.view.frame;
    const std::size_t particle = *hands.kicked;
    if (particle >= frame.positions.size() || !render::drawable(frame.seen(particle))) {
        hands.kicked.reset();
        return;
    }
    const Rate rate = context.state.wanted.rate();
    const Vec3 arrow = under_pointer_beside(frame.seen(particle), context, projection) - frame.seen(particle);
    hands.kick = (1 / (frame.magnified * (rate.as_fast_as_possible ? 1 : rate.seconds_per_second))) * arrow;
    if (ImGui::GetIO().MouseDown[1]) return;
    if (is_dragged(context, 1)) kick(context, particle, hands.kick);
    hands.kicked.reset();
}

/// Particles whose middle is within the box.
std::vector<std::size_t> in_box(const Context& context, const render::Projection& projection) {
    const Frame& frame = context.view.frame;
    const render::PixelPoint a = *context.state.hands.box_from, b = pointer_place(context);
    const auto is_between = [](double x, double from, double to) {
        return x >= std::min(from, to) && x <= std::max(from, to);
    };
    std::vector<std::size_t> inside;
    for (std::size_t i = 0; i < frame.positions.size(); ++i) {
        const Vec3 seen = frame.seen(i);
        const auto pixel = render::drawable(seen) ? projection.pixel(seen) : std::nullopt;
        if (pixel && is_between(pixel->x, a.x, b.x) && is_between(pixel->y, a.y, b.y)) inside.push_back(i);
    }
    return inside;
}

void draw_box(const Context& context, const render::Projection& projection) {
    if (ImGui::GetIO().MouseDown[0]) return;
    Hands& hands = context.state.hands;
    if (is_dragged(context, 0)) {
        context.state.selection.take(in_box(context, projection), ImGui::GetIO().KeyShift, context.view,
                                     context.events);
    } else {
        click_particle(context, projection);
    }
    hands.box_from.reset();
    hands.selecting = false;
}

void begin_pull(const Context& context, const render::Projection& projection) {
    Hands& hands = context.state.hands;
    hands.pulled = particle_under_pointer(context, projection);
    hands.tugged_at.reset();
    hands.moved = false;
    if (hands.pulled && !context.state.selection.contains(*hands.pulled, context.view))
        context.state.selection.only(*hands.pulled, context.events);
}

}  // namespace

Vec3 beside(Vec3 place, render::PixelPoint pixel, const render::Projection& projection) {
    const render::Ray ray = projection.ray(pixel);
    const Vec3 forward = projection.forward();
    return ray.origin + (dot(place - ray.origin, forward) / dot(ray.direction, forward)) * ray.direction;
}

void pull_to(const Context& context, std::size_t particle, Vec3 place) {
    Hands& hands = context.state.hands;
    hands.pulled_in = context.view.run;
    if (context.view.playing) return tug(context, particle, place);
    hands.tugged_at.reset();
    context.events.send(event::Do{
        Pull{particle, context.view.frame.position_drawn_at(particle, place), others_with(particle, context)}});
}

std::optional<std::size_t> particle_under_pointer(const Context& context, const render::Projection& projection) {
    const PixelRect tile = context.tile();
    const render::PixelPoint place = pointer_place(context);
    const bool inside = place.x >= 0 && place.x < tile.width && place.y >= 0 && place.y < tile.height;
    if (!inside && context.tiles().size() > 1)
        return std::nullopt;  // particles of other runs are not the ones that are picked
    return render::particle_at(context.view.frame, context.sizes(), projection, place,
                               static_cast<double>(context.px(10)));
}

bool begin_gesture(const Context& context, const render::Projection& projection) {
    const ImGuiIO& io = ImGui::GetIO();
    Hands& hands = context.state.hands;
    if (went_down(0) && (hands.selecting || io.KeyAlt)) {
        hands.box_from = pointer_place(context);
    } else if (went_down(0) && io.KeyCtrl) {
        begin_pull(context, projection);
    } else if (went_down(1) && io.KeyCtrl) {
        hands.kicked = particle_under_pointer(context, projection);
        return hands.kicked.has_value();
    } else {
        return false;
    }
    return true;
}

void use_hands(const Context& context, const render::Projection& projection) {
    const Hands& hands = context.state.hands;
    if (hands.pulled) pull(context, projection);
    if (hands.kicked) aim(context, projection);
    if (hands.box_from) draw_box(context, projection);
}

void click_particle(const Context& context, const render::Projection& projection) {
    const auto particle = particle_under_pointer(context, projection);
    if (!particle) return;
    Selection& selection = context.state.selection;
    if (ImGui::GetIO().KeyShift) return selection.toggle(*particle, context.view, context.events);
    selection.only(*particle, context.events);
}

void kick(const Context& context, std::size_t particle, Vec3 velocity) {
    context.events.send(event::Do{Kick{particle, velocity, others_with(particle, context)}});
    context.state.hands.pulled_in = context.view.run;
}

}  // namespace steplab::ui
