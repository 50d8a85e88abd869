#version 330 core
// A finished picture as a ground for lines: what exposure and clamping make of it, a share of its light, not yet encoded.
uniform sampler2D source;
uniform float exposure, share;
out vec4 result;

void main() {
    vec3 color = texelFetch(source, ivec2(gl_FragCoord.xy), 0).rgb;
    result = vec4(clamp(color * exposure, 0.0, 1.0) * share, 1.0);
}
