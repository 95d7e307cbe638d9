#version 330 core
// Balls so far away that their shape is not visible: one small square per particle, with the area of the disc.

layout(location = 0) in vec3 a_centre;
layout(location = 1) in vec4 a_colour;  // alpha: part of u_radius that the ball has

uniform float u_radius;
uniform float u_least_radius;  // pixels

#include "view.glsl"
#include "front.glsl"
#include "lighting.glsl"

flat out vec3 v_colour;

const float side_of_disc = 1.7724539;  // sqrt(pi), in radii

void main() {
    float own_radius = a_colour.a * u_radius;
    vec3 centre = seen(a_centre);
    float radius = max(own_radius * u_pixels / -centre.z, u_least_radius);
    // A ball is darker towards its outline: the mean over its disc.
    float mean = 1.0 - 0.12 * min(radius * radius, 1.0);
    v_colour = mean * lit(a_colour.rgb, vec3(0.0, 0.0, 1.0), vec3(0.0, 0.0, 1.0));
    gl_Position = front_of_ball(centre, own_radius);
    gl_PointSize = side_of_disc * radius;
}
