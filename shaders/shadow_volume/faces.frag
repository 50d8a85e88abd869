#version 330 core
// A face of a shadow volume, coloured by the side that faces the viewer, since the stencil adds one for a front and
// subtracts one for a back.
uniform vec4 frontColor;
uniform vec4 backColor;
out vec4 result;

void main() { result = gl_FrontFacing ? frontColor : backColor; }
