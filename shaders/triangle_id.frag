#version 330 core
// Which triangle is seen in this pixel: its number over all objects of the scene.
#include "cut_holes.glsl"
uniform int triangleBase; // scene-wide index of the first triangle of this draw call
out uint triangle;

// [anchor: triangle-number]
void main() {
    cutHoles();
    triangle = uint(triangleBase + gl_PrimitiveID);
}
