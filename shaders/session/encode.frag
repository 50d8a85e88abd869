#version 330 core
// The last step of every picture: average the samples of a pixel in linear light, expose, clamp, encode as sRGB.
uniform sampler2D source;
uniform int supersample;  // N: a pixel is the average of N x N texels
uniform int mode;         // 0 radiance, 1 colours as they are, 2 value through the palette, 3 visibility, 4 ground under verdicts
uniform float exposure;
uniform float minimum, maximum;
uniform vec4 palette[9];
out vec4 encoded;

// Where a picture has no value at all: a dark neutral that no palette contains.
const vec3 kNoValue = vec3(0.012);

vec3 throughPalette(float value) {
    float at = clamp((value - minimum) / (maximum - minimum), 0.0, 1.0) * 8.0;
    int below = min(int(at), 7);
    return mix(palette[below].rgb, palette[below + 1].rgb, at - float(below));
}

vec3 linearColor(vec4 texel) {
    if (mode == 2) return texel.g > 0.5 ? throughPalette(texel.r) : kNoValue;
    if (mode == 3) return texel.g > 0.5 ? vec3(texel.r) : kNoValue;
    if (mode == 1 && texel.a < 0.5) return kNoValue;
    return texel.rgb;
}

// IEC 61966-2-1.
vec3 srgbFromLinear(vec3 color) {
    return mix(12.92 * color, 1.055 * pow(color, vec3(1.0 / 2.4)) - 0.055, greaterThan(color, vec3(0.0031308)));
}

void main() {
    ivec2 first = ivec2(gl_FragCoord.xy) * supersample;
    vec3 sum = vec3(0.0);
    for (int y = 0; y < supersample; ++y)
        for (int x = 0; x < supersample; ++x) sum += linearColor(texelFetch(source, first + ivec2(x, y), 0));
    vec3 color = sum / float(supersample * supersample);
    if (mode == 0 || mode == 4) color *= exposure;
    // Rec. 709 luminance; as much of white is added as app/session/verdict_panels.cpp adds.
    if (mode == 4) color = vec3(mix(0.3, 1.0, dot(clamp(color, 0.0, 1.0), vec3(0.2126, 0.7152, 0.0722))));
    encoded = vec4(srgbFromLinear(clamp(color, 0.0, 1.0)), 1.0);
}
