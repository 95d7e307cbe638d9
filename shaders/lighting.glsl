// One soft light from the upper left that moves with the camera, and a sky above a darker ground.

const vec3 light_direction = normalize(vec3(-0.42, 0.70, 0.58));

uniform float u_sky;    // light from above that reaches every surface
uniform float u_earth;  // and from below

// x^48, in fewer instructions than pow() takes in a software renderer.
float to_the_48th(float x) {
    float third = x * x * x;
    float sixth = third * third;
    float twelfth = sixth * sixth;
    float half_way = twelfth * twelfth;
    return half_way * half_way;
}

// Colour of a surface; `normal` and `to_eye` have length 1, in the eye's space.
vec3 lit(vec3 colour, vec3 normal, vec3 to_eye) {
    vec3 up = u_rotation[1];
    float sky = 0.5 + 0.5 * dot(normal, up);
    float wrapped = max((dot(normal, light_direction) + 0.35) / 1.35, 0.0);
    float facing = max(dot(normal, to_eye), 0.0);
    float shade = mix(u_earth, u_sky, sky) + 0.72 * wrapped * wrapped;
    float edge = mix(0.72, 1.0, smoothstep(0.0, 0.55, facing));
    float glint = to_the_48th(max(dot(normal, normalize(light_direction + to_eye)), 0.0));
    return colour * shade * edge + vec3(0.26 * glint);
}
