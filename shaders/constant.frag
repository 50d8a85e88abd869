#version 330 core
// One colour for everything drawn.
#include "cut_holes.glsl"
uniform vec4 color;
out vec4 result;

void main() {
    cutHoles();
    result = color;
}
