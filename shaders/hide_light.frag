#version 330 core
// Adds a light's bit where it is hidden; the stencil says where.
uniform vec4 bit;
out vec4 result;

void main() { result = bit; }
