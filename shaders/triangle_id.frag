#version 330 core
// Which triangle is seen in this pixel: its number over all objects of the scene.
#include "cut_holes.glsl"
flat in int triangleOfScene;
out uint triangle;

// [anchor: triangle-number]
void main() {
    cutHoles();
    triangle = uint(triangleOfScene);
}
