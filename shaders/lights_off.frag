#version 330 core
// What is seen with all lights off.
#include "material.glsl"
#include "lights_off.glsl"
#include "cut_holes.glsl"
out vec4 radiance;

void main() {
    cutHoles();
    radiance = vec4(lightsOffRadiance(), 1.0);
}
