#version 330 core
// One light's contribution to one pixel. Two outputs share it: the reflected radiance, and the visibility alone.
#include "material.glsl"
#include "light.glsl"
#include "facing.glsl"
in vec3 positionView;
in vec3 normalView;
uniform int receivesShadow;
out vec4 result;
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
    vec3 shadingNormalView = normalize(normalView);
    if (dot(shadingNormalView, toEyeView) < 0.0) shadingNormalView = -shadingNormalView;
    vec3 lightView = visibility * irradiance(shadingNormalView, toLightView, distanceSquared);
    // In a degenerate direction the reflectance is NaN, and 0 * NaN is NaN: so it is not multiplied where nothing is
    // visible.
    result = visibility > 0.0 ? vec4(lightView * reflectance(shadingNormalView, toLightView, toEyeView), 0.0) : vec4(0.0);
#endif
}
