#version 330 core
// How large a texel of the map lies on screen: the longest extent, in pixels, of one texel projected onto the surface.
//
// A step of one pixel to the right, or up, moves the point on its plane, and so its place in the map: a matrix of two
// by two numbers, texels per pixel. The direction in which that is least is the one in which a texel is longest: one
// over the matrix's smaller singular value. After Lloyd, Govindaraju, Quammen, Molnar and Manocha, "Logarithmic
// Perspective Shadow Maps", ACM Transactions on Graphics 27(4), 2008, who measure aliasing this way.
#include "light.glsl"
#include "facing.glsl"
in vec3 positionView;
#include "shadow_map/lookup.glsl"
uniform float longest;    // pixels: what is longer (a surface that the light sees edge-on) counts as this
out vec4 result;

// Texels per pixel, along a step on the surface. The map's place is x / w and y / w of a linear function of the point.
vec2 texelsAlong(vec3 stepLightRelative, vec4 lightClip, int layer) {
    vec4 stepClip = lightClipFromLightRelative[layer] * vec4(stepLightRelative, 0.0);
    return 0.5 * resolution * (stepClip.xy * lightClip.w - lightClip.xy * stepClip.w) / (lightClip.w * lightClip.w);
}

void main() {
    int layer = mapLayer(positionLightRelative);
    vec4 lightClip = lightClipFromLightRelative[layer] * vec4(positionLightRelative, 1.0);
    vec2 alongX = texelsAlong(rightLightRelative, lightClip, layer);
    vec2 alongY = texelsAlong(upLightRelative, lightClip, layer);
    // Singular values of a matrix are half the sum, and half the difference, of these two.
    float sum = length(vec2(alongX.x + alongY.y, alongX.y - alongY.x));
    float difference = length(vec2(alongX.x - alongY.y, alongX.y + alongY.x));
    float smaller = 0.5 * abs(sum - difference);
    float size = smaller * longest > 1.0 ? 1.0 / smaller : longest; // also where it is no number

    float distanceSquared;
    bool asked = eyeSideFacesLight() && lightShinesTo(towardLight(positionView, distanceSquared));
    bool inside = lightClip.w > 0.0 && all(lessThan(abs(lightClip.xy), vec2(lightClip.w)));
    result = vec4(size, asked && inside ? 1.0 : 0.0, 0.0, 1.0);
}
