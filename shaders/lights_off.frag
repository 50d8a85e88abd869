#version 330 core
// What is seen with all lights off: the surface's own emission and the ambient light it reflects.
#include "material.glsl"
#include "cut_holes.glsl"
uniform vec3 ambient;
uniform int emitsFromFrontOnly; // a rect light's surface is dark on its back
out vec4 radiance;

// [anchor: lights-off]
void main() {
    cutHoles();
    bool emits = emitsFromFrontOnly == 0 || gl_FrontFacing;
    radiance = vec4((emits ? emission : vec3(0.0)) + ambient * diffuse, 1.0);
}
