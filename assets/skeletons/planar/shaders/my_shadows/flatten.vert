#version 330 core
// A caster's vertex where its shadow falls. The position stays homogeneous: at the light's height its weight is 0, a point at
// infinity, and nobody divides by it.
#include "attributes.glsl"
#include "clip_position.glsl"
#include "texcoord.glsl"
uniform vec4 abovePlane; // a row: times the vertex; clipped where negative
out float gl_ClipDistance[1];

void main() {
    gl_Position = clipPosition(vec4(positionMesh, 1.0));
    passTexcoord();
    gl_ClipDistance[0] = dot(abovePlane, vec4(positionMesh, 1.0));
}
