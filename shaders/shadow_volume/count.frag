#version 330 core
// The number that a face of a shadow volume adds to a count in a float texture.
uniform float front, back;
out vec4 result;

void main() { result = vec4(gl_FrontFacing ? front : back); }
