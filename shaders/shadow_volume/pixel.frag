#version 330 core
// For a pass that only writes the stencil, in all pixels that are drawn.
void main() {}
