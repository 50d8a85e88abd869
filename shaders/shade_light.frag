#version 330 core
// One light's contribution to one pixel. What is written of it is chosen by a define:
//   (none)           the reflected radiance, to be added to what is there
//   VISIBILITY_ONLY  the visible share of the light alone
//   FINISHED         the pixel as it is shown: this light and what there is with lights off, exposed and encoded
//   IN_SHADOW_TOO    with FINISHED: a second output, the pixel as it is shown where the light is hidden
#include "material.glsl"
#include "light.glsl"
#include "facing.glsl"
#include "shading_normal.glsl"
in vec3 positionView;
in vec3 normalView;
uniform int receivesShadow;
layout(location = 0) out vec4 result;
#ifdef FINISHED
#include "lights_off.glsl"
#include "srgb.glsl"
uniform float exposure;

vec3 shown(vec3 radiance) { return srgbFromLinear(clamp(exposure * radiance, 0.0, 1.0)); }
#endif
#ifdef IN_SHADOW_TOO
layout(location = 1) out vec4 inShadow;
#ifndef COLORED
uniform vec3 frontInShadow, backInShadow; // finished: the two sides of the surface with lights off, the same all over it
#endif
#endif
#include "shadow_visibility.glsl"

// [anchor: shade-light]
void main() {
    float distanceSquared;
    vec3 toLightView = towardLight(positionView, distanceSquared);
    bool gate = eyeSideFacesLight() && lightShinesTo(toLightView);
    float visibility = !gate ? 0.0 : receivesShadow == 0 ? 1.0 : shadowVisibility();
#ifdef VISIBILITY_ONLY
    result = vec4(visibility, 1.0, 0.0, 1.0);
#else
    vec3 toEyeView = normalize(-positionView);
    vec3 shadingNormalView = shadingNormal(normalView, positionView);
    vec3 lightView = visibility * irradiance(shadingNormalView, toLightView, distanceSquared);
    // In a degenerate direction the reflectance is NaN, and 0 * NaN is NaN: so it is not multiplied where nothing is
    // visible.
    vec3 reflected = visibility > 0.0 ? lightView * reflectance(shadingNormalView, toLightView, toEyeView) : vec3(0.0);
#ifdef FINISHED
    result = vec4(shown(lightsOffRadiance() + reflected), 1.0);
#else
    result = vec4(reflected, 0.0);
#endif
#ifdef IN_SHADOW_TOO
#ifdef COLORED
    vec3 unlit = shown(lightsOffRadiance());
#else
    vec3 unlit = gl_FrontFacing ? frontInShadow : backInShadow;
#endif
    inShadow = receivesShadow == 0 ? result : vec4(unlit, 1.0);
#endif
#endif
}
