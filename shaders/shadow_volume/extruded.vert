#version 330 core
// A vertex of a shadow volume that the processor has extruded: w = 0 is at infinity.
#include "clip_position.glsl"
layout(location = 0) in vec4 homogeneousMesh;

void main() { gl_Position = clipPosition(homogeneousMesh); }
