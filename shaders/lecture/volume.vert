#version 330 core
// A vertex of a shadow volume, in mesh space and homogeneous: w = 1 where it is a place, w = 0 where it lies at infinity.
#include "clip_position.glsl"
layout(location = 0) in vec4 homogeneousMesh;

void main() { gl_Position = clipPosition(homogeneousMesh); }
