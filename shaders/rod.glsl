// One quad per rod (spring, line of an axis), facing the camera, at least u_least_width pixels wide; or one line.

layout(location = 0) in vec3 a_start;
layout(location = 1) in vec3 a_end;
layout(location = 2) in vec4 a_colour;

uniform float u_radius;       // 0: a line
uniform float u_least_width;  // pixels
uniform float u_breadth;      // 1: quads; 0: lines
uniform float u_fading;       // rods shorter than this, in pixels, are fainter
uniform float u_faded;        // rods as short as this are invisible

struct RodCorner {
    vec3 position;   // in the eye's space
    vec3 side;       // in the eye's space, of length 1
    float across;    // -1 or 1: which side
    float diameter;  // pixels
    float alpha;
};

// The corner of this vertex.
RodCorner rod_corner() {
    RodCorner corner;
    vec3 start = seen(a_start);
    vec3 end = seen(a_end);
    vec3 position = (gl_VertexID & 1) != 0 ? end : start;
    corner.side = normalize(cross(end - start, -position) + vec3(1e-30, 0.0, 0.0));
    corner.across = (gl_VertexID & 2) != 0 ? 1.0 : -1.0;
    float least_radius = 0.5 * u_least_width * max(-position.z, 0.0) / u_pixels;
    float radius = max(u_radius, least_radius);
    corner.position = position + u_breadth * corner.across * radius * corner.side;
    corner.diameter = 2.0 * radius * u_pixels / max(-position.z, 1e-30);
    // A rod below the smallest width is drawn fainter instead; a plain line has no thickness of its own.
    float thinness = u_radius > 0.0 ? u_radius / radius : 1.0;
    // The visible length; the rest is along the line of sight.
    float pixels = length(cross(end - start, normalize(position))) * u_pixels / max(-position.z, 1e-30);
    corner.alpha = a_colour.a * mix(1.0, thinness, 0.6) * smoothstep(u_faded, u_fading, pixels);
    return corner;
}
