// One light: the irradiance it would give without shadows, and the gates that belong to visibility in every technique.
// The C++ twin is techniques/foundation/scene/query/shading.h.
#ifdef LIGHTS // a program that shades with all lights of the scene
#include "lights.glsl"
#else
#ifdef LIGHT_KIND // a constant of the program: gl::useForLight
const int lightKind = LIGHT_KIND; // 0 point (and sphere), 1 directional, 2 spot, 3 rect
#else
uniform int lightKind;
#endif
uniform vec3 lightPositionView;
uniform vec3 lightDirectionView; // unit: the way the light travels; rect: its normal
uniform vec3 lightIntensity;
uniform float lightHalfCone, lightCosHalfCone, lightEdge; // radians
#endif

// Unit vector from the surface toward the light, and the squared distance to it.
vec3 towardLight(vec3 positionView, out float distanceSquared) {
    if (lightKind == 1) {
        distanceSquared = 1.0;
        return -lightDirectionView;
    }
    vec3 offsetView = lightPositionView - positionView;
    distanceSquared = dot(offsetView, offsetView);
    return offsetView * inversesqrt(distanceSquared);
}

// Nothing is lit outside of a spot's cone or behind a rect, with or without shadows.
bool lightShinesTo(vec3 toLightView) {
    if (lightKind == 2) return dot(-toLightView, lightDirectionView) > lightCosHalfCone;
    if (lightKind == 3) return dot(-toLightView, lightDirectionView) > 0.0;
    return true;
}

// Irradiance on a surface with that normal; zero for a light behind it.
// [anchor: irradiance]
vec3 irradiance(vec3 normalView, vec3 toLightView, float distanceSquared) {
    float falloff = max(dot(normalView, toLightView), 0.0) / distanceSquared;
    float cosAtLight = dot(-toLightView, lightDirectionView);
    if (lightKind == 3) falloff *= max(cosAtLight, 0.0);
    if (lightKind == 2 && lightEdge > 0.0)
        falloff *= smoothstep(0.0, lightEdge, lightHalfCone - acos(clamp(cosAtLight, -1.0, 1.0)));
    return lightIntensity * falloff;
}
