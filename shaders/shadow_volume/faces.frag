#version 330 core
// A face of a shadow volume, by the side it turns to the viewer: what the stencil adds for one and takes for the other.
uniform vec4 frontColor;
uniform vec4 backColor;
out vec4 result;

void main() { result = gl_FrontFacing ? frontColor : backColor; }
