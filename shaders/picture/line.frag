#version 330 core
// A line with round ends, its border smoothed by the share of the pixel that it covers.
uniform vec4 color;
uniform float halfWidth; // pixels
flat in vec2 from, to;
out vec4 result;

void main() {
    vec2 along = to - from, offset = gl_FragCoord.xy - from;
    float share = clamp(dot(offset, along) / max(dot(along, along), 1e-12), 0.0, 1.0);
    float coverage = clamp(halfWidth + 0.5 - length(offset - share * along), 0.0, 1.0);
    if (coverage == 0.0) discard;
    result = vec4(color.rgb, color.a * coverage);
}
