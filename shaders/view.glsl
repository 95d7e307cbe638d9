// The camera, for all shaders of the scene. Positions are relative to the focus of the camera, lengths in units of its
// distance.

uniform mat3 u_rotation;  // to the eye's space: x to the right, y up, z towards the eye
uniform vec3 u_eye;
uniform mat4 u_clip;      // from the eye's space to clip space
uniform float u_pixels;   // pixels that a length of 1 at depth 1 covers
uniform vec3 u_backdrop;  // mean colour behind the scene

vec3 seen(vec3 position) { return u_rotation * (position - u_eye); }
