#version 330 core
// Keeps only the pixels that a mask marks, for a pass that writes the stencil there.
uniform sampler2D flips; // red: 1 where the pixel is marked; rows from the top
uniform vec2 upperLeft;  // of the mask, in pixels from the lower left corner of the target

void main() {
    vec2 fromUpperLeft = vec2(gl_FragCoord.x - upperLeft.x, upperLeft.y - gl_FragCoord.y);
    if (texelFetch(flips, ivec2(floor(fromUpperLeft)), 0).r < 0.5) discard;
}
