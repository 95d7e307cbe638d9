#version 330 core
// Small balls, far away: one point per particle.

layout(location = 0) in vec3 a_centre;
layout(location = 1) in vec4 a_colour;  // alpha: part of u_radius that the ball has

uniform float u_radius;
uniform float u_least_radius;  // pixels

#include "view.glsl"
#include "front.glsl"

flat out vec3 v_colour;
flat out float v_radius;  // pixels

void main() {
    float own_radius = a_colour.a * u_radius;
    vec3 centre = seen(a_centre);
    v_colour = a_colour.rgb;
    v_radius = max(own_radius * u_pixels / -centre.z, u_least_radius);
    gl_Position = front_of_ball(centre, own_radius);
    gl_PointSize = 2.0 * v_radius + 1.0;
}
