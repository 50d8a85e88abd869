#version 330 core
// One colour for everything drawn.
uniform vec4 color;
out vec4 result;

void main() { result = color; }
