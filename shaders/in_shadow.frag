#version 330 core
// Copies the pixel of a picture in which the light is hidden everywhere; the stencil says where.
uniform sampler2D inShadow;
out vec4 result;

void main() { result = texture(inShadow, gl_FragCoord.xy / vec2(textureSize(inShadow, 0))); } // the nearest: cheaper than a fetch
