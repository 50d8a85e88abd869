#version 330 core
// What a pixel has gathered of the light that patches send, reflected by the pixel's own material as a Lambertian surface does.
#include "material.glsl"
uniform sampler2D irradiance; // of each pixel, W/m^2
uniform float exposureFactor;
out vec4 result;

void main() {
    result = vec4(exposureFactor * surfaceDiffuse() / kPi * texelFetch(irradiance, ivec2(gl_FragCoord.xy), 0).rgb, 0.0);
}
