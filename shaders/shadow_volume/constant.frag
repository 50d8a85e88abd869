#version 330 core
// One colour for everything drawn: lines, and the full-screen passes that read the stencil.
uniform vec4 color;
out vec4 result;

void main() { result = color; }
