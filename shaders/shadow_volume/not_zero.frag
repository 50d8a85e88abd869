#version 330 core
// Keeps only the pixels whose count is not zero, for a pass that writes the stencil there.
uniform sampler2D counts;

void main() {
    if (abs(texelFetch(counts, ivec2(gl_FragCoord.xy), 0).r) < 0.5) discard;
}
