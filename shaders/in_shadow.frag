#version 330 core
// Copies the pixel of a picture in which the light is hidden everywhere; the stencil says where.
uniform sampler2D inShadow;
out vec4 result;

void main() { result = texelFetch(inShadow, ivec2(gl_FragCoord.xy), 0); }
