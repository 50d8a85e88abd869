#version 330 core
// A label, as the processor has drawn it, onto its rectangle of the picture.
uniform sampler2D label; // row 0 is the upper one
uniform vec2 upperLeft;  // of the rectangle: its left column, and its uppermost row, in the picture's pixels from below
out vec4 result;

void main() {
    vec2 texel = vec2(gl_FragCoord.x - upperLeft.x, upperLeft.y + 1.0 - gl_FragCoord.y);
    result = vec4(texelFetch(label, ivec2(texel), 0).rgb, 1.0);
}
