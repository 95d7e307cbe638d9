// The centre of a ball in clip space with the depth of its front, so that springs do not cover the balls at their ends.
vec4 front_of_ball(vec3 centre, float radius) {
    vec4 place = u_clip * vec4(centre, 1.0);
    vec2 front = (u_clip * vec4(0.0, 0.0, min(centre.z + radius, 0.5 * centre.z), 1.0)).zw;
    return vec4(place.xy, front.x / front.y * place.w, place.w);
}
