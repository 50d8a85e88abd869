#version 330 core
// A receiver's surface behind the triangle that the light lies on (techniques/planar/casters.h, NearTriangle).
#include "attributes.glsl"
#include "clip_position.glsl"
#include "texcoord.glsl"
uniform vec4 behindRow; // times the vertex: positive behind
out float gl_ClipDistance[1];

void main() {
    gl_Position = clipPosition(vec4(positionMesh, 1.0));
    passTexcoord();
    gl_ClipDistance[0] = dot(behindRow, vec4(positionMesh, 1.0));
}
