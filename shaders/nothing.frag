#version 330 core
// For passes that only touch depth or stencil.
#include "cut_holes.glsl"

void main() { cutHoles(); }
