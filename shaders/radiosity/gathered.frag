#version 330 core
// The pixel's own emission, and what it has gathered of the light that patches send, reflected by its own material as a Lambertian
// surface does.
#include "material.glsl"
uniform sampler2D irradiance; // of each pixel, W/m^2
uniform float exposureFactor;
uniform int emittingSides; // 1: the front of the drawn triangle shines, 2: its back, 3: both
out vec4 result;

void main() {
    vec3 ownRadiance = (emittingSides & (gl_FrontFacing ? 1 : 2)) != 0 ? emission : vec3(0.0);
    vec3 gathered = texelFetch(irradiance, ivec2(gl_FragCoord.xy), 0).rgb;
    result = vec4(exposureFactor * (ownRadiance + surfaceDiffuse() / kPi * gathered), 1.0);
}
