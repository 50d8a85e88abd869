#version 330 core
// The last step of every picture: average the samples of a pixel in linear light, expose, clamp, encode as sRGB.
// One of these is defined: what the source holds. A program for each, because processors that stand in for graphics cards
// would compute all of them for every pixel, and this runs in every frame.
//   RADIANCE    radiance, to be exposed
//   GROUND      the same, without its colours and its shadows lifted: the ground under verdicts
//   SWATCHES    colours as they are
//   PALETTE     a value, shown through the palette
//   COUNT       the same, painted on the finished picture without its colours, so that the things that are counted on are seen
//   VISIBILITY  a share of a light
// And, where a pixel is one texel, ONE_SAMPLE: no loops then.
uniform sampler2D source;
#ifdef ONE_SAMPLE
const int supersample = 1;
#else
uniform int supersample; // N: a pixel is the average of N x N texels
#endif
out vec4 encoded;

// Where a picture has no value at all: a dark neutral that no palette contains.
const vec3 kNoValue = vec3(0.012);

#if defined(RADIANCE) || defined(GROUND)
uniform float exposure;

vec3 linearColor(vec4 texel) { return exposure * texel.rgb; }

#elif defined(PALETTE) || defined(COUNT)
uniform float minimum, maximum;
uniform vec4 palette[9];

vec3 linearColor(vec4 texel) {
    float at = clamp((texel.r - minimum) / (maximum - minimum), 0.0, 1.0) * 8.0;
    int below = min(int(at), 7);
    return texel.g > 0.5 ? mix(palette[below].rgb, palette[below + 1].rgb, at - float(below)) : kNoValue;
}

#ifdef COUNT
uniform sampler2D ground; // the target, as large as the source
uniform float exposure;

// The palette's colour in the brightness of the ground, whose dark parts are lifted: a count has to be told in shadow as well.
vec3 onGround(vec3 color, ivec2 at) {
    float luminance = dot(exposure * texelFetch(ground, at, 0).rgb, vec3(0.2126, 0.7152, 0.0722)); // Rec. 709
    return color * mix(0.3, 1.0, sqrt(clamp(luminance, 0.0, 1.0)));
}
#endif

#elif defined(VISIBILITY)
vec3 linearColor(vec4 texel) { return texel.g > 0.5 ? vec3(texel.r) : kNoValue; }

#elif defined(SWATCHES)
vec3 linearColor(vec4 texel) { return texel.a < 0.5 ? kNoValue : texel.rgb; }
#endif

#include "srgb.glsl"

void main() {
#ifdef ONE_SAMPLE
    vec3 sum = linearColor(texture(source, gl_FragCoord.xy / vec2(textureSize(source, 0)))); // the nearest: cheaper than a fetch
#else
    ivec2 first = ivec2(gl_FragCoord.xy) * supersample;
    vec3 sum = vec3(0.0);
    for (int y = 0; y < supersample; ++y)
        for (int x = 0; x < supersample; ++x) {
            vec4 texel = texelFetch(source, first + ivec2(x, y), 0);
#ifdef COUNT
            sum += texel.g > 0.5 ? onGround(linearColor(texel), first + ivec2(x, y)) : kNoValue;
#else
            sum += linearColor(texel);
#endif
        }
#endif
    vec3 color = clamp(sum / float(supersample * supersample), 0.0, 1.0);
#ifdef GROUND
    // Rec. 709 luminance; as much of white is added as app/picture/verdict_panels.cpp adds.
    color = vec3(mix(0.3, 1.0, dot(color, vec3(0.2126, 0.7152, 0.0722))));
#endif
    encoded = vec4(srgbFromLinear(color), 1.0);
}
