#version 330 core
// Position alone: for passes that only touch depth or stencil.
#include "attributes.glsl"
#include "clip_position.glsl"
#include "texcoord.glsl"
#include "triangle.glsl"

void main() {
    gl_Position = clipPosition(vec4(positionMesh, 1.0));
    passTexcoord();
    passTriangle();
}
