#version 330 core
// A point of an object, projected onto a plane. It stays homogeneous: for a point at the light's height w' is 0 and P' is infinitely
// far away, which is right as long as nothing divides by it.
#include "attributes.glsl"
#include "clip_position.glsl"
#include "texcoord.glsl"
uniform vec4 abovePlaneMesh; // (N, D) of the plane: N.P + D
out float gl_ClipDistance[1];

// [anchor: projection-vertex]
void main() {
    gl_Position = clipPosition(vec4(positionMesh, 1.0)); // clipFromMesh has the projection onto the plane in it
    gl_ClipDistance[0] = dot(abovePlaneMesh, vec4(positionMesh, 1.0));
    passTexcoord();
}
