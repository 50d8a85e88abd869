#version 330 core
// All lights of one pixel at once, and the pixel as it is shown: exposed and encoded. Of which of them it lies in the shadow is known
// beforehand: a bit for each light, eight to a channel. NOTHING_HIDDEN: of none.
#include "material.glsl"
#include "light.glsl"
#include "facing.glsl"
#include "shading_normal.glsl"
#include "lights_off.glsl"
#include "srgb.glsl"
in vec3 positionView;
in vec3 normalView;
uniform int receivesShadow;
uniform float exposure;
#ifndef NOTHING_HIDDEN
uniform sampler2D hiddenLights;
#endif
layout(location = 0) out vec4 result;

// The lights that this pixel is not hidden from.
uvec4 shownLights() {
#ifdef NOTHING_HIDDEN
    return uvec4(255u);
#else
    vec2 place = gl_FragCoord.xy / vec2(textureSize(hiddenLights, 0)); // its nearest texel: cheaper than a fetch
    uvec4 hidden = uvec4(255.0 * texture(hiddenLights, place) + 0.5);
    return receivesShadow == 0 ? uvec4(255u) : ~hidden;
#endif
}

void main() {
    uvec4 shown = shownLights();
    uint faced = lightsAtEyeSide();
    vec3 toEyeView = normalize(-positionView);
    vec3 shadingNormalView = shadingNormal(normalView, positionView);
    vec3 radiance = lightsOffRadiance();
    for (int light = 0; light < LIGHTS; ++light) {
        chooseLight(light);
        float distanceSquared;
        vec3 toLightView = towardLight(positionView, distanceSquared);
        bool isLit = (shown[light / 8] >> uint(light % 8) & faced >> uint(light) & 1u) != 0u && lightShinesTo(toLightView);
        // As in shade_light.frag: in a degenerate direction the reflectance is NaN, so it is not multiplied where nothing is visible.
        if (isLit)
            radiance += irradiance(shadingNormalView, toLightView, distanceSquared) *
                        reflectance(shadingNormalView, toLightView, toEyeView);
    }
    result = vec4(srgbFromLinear(clamp(exposure * radiance, 0.0, 1.0)), 1.0);
}
