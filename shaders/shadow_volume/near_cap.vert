#version 330 core
// A vertex of a top cap, of which only what lies before the near plane is kept.
#include "attributes.glsl"
#include "clip_position.glsl"
out float gl_ClipDistance[1];

void main() {
    gl_Position = clipPosition(vec4(positionMesh, 1.0));
    gl_ClipDistance[0] = -(gl_Position.z + gl_Position.w);
}
