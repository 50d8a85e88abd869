#version 330 core
// One brightness everywhere.
uniform float brightness;
out vec4 result;
void main() { result = vec4(vec3(brightness), 1.0); }
