#version 330 core
// What a face of a shadow volume adds to a count that is kept as a number in a texture.
uniform float front, back;
out vec4 result;

void main() { result = vec4(gl_FrontFacing ? front : back); }
