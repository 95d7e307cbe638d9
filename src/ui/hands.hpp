#pragma once

#include "core/vec3.hpp"
#include "ui/context.hpp"

#include <cstddef>
#include <optional>

namespace steplab::ui {

/// The particle under the pointer, if it is one of the leading run.
std::optional<std::size_t> particle_under_pointer(const Context& context, const render::Projection& projection);

/// A button was pressed over the scene: true if a gesture with particles begins, which the camera is no part of.
bool begin_gesture(const Context& context, const render::Projection& projection);
/// Goes on with it: pulls a particle, while the run plays by a spring; aims a kick and gives it; draws a box and
/// selects what is in it.
void use_hands(const Context& context, const render::Projection& projection);
/// The point that is drawn at a pixel, in the plane through `place` that faces the eye.
Vec3 beside(Vec3 place, render::PixelPoint pixel, const render::Projection& projection);
/// Pulls a particle, and the other selected ones if it is one of them, to be seen at a place: at once, or while the run
/// plays by a spring, as far as that has drawn it since the step seen before.
void pull_to(const Context& context, std::size_t particle, Vec3 place);
/// Kicks a particle by this velocity [m/s], and the other selected ones if it is one of them.
void kick(const Context& context, std::size_t particle, Vec3 velocity);
/// A click: selects the particle under the pointer; with Shift, adds it or takes it away.
void click_particle(const Context& context, const render::Projection& projection);

}  // namespace steplab::ui
