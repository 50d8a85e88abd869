#version 330 core
// The picture without its colours, as a ground to draw coloured lines and faces on. Rec. 709 luminance.
uniform sampler2D source;
out vec4 result;

void main() {
    vec3 color = texelFetch(source, ivec2(gl_FragCoord.xy), 0).rgb;
    result = vec4(vec3(dot(color, vec3(0.2126, 0.7152, 0.0722))), 1.0);
}
