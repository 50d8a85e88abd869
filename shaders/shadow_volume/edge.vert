#version 330 core
// An edge of a caster, drawn a little nearer to the eye than the surface it lies on so that it is not half buried.
#include "attributes.glsl"
uniform mat4 clipFromMesh;
uniform float pullClip; // subtracted from clip z: scales the distance to the eye by a constant share

void main() {
    gl_Position = clipFromMesh * vec4(positionMesh, 1.0);
    gl_Position.z -= pullClip;
}
