#version 330 core
// The lecture's pictures of the shadow map: what it stores, projected onto what the eye sees.
#include "lecture/shadow_map.glsl"
uniform int shown; // 0: light depth d(u,v); 1: light distance z(u,v); 2: their comparison
uniform vec3 equalColor, shadowedColor;
out vec4 result;

void main() {
    vec3 str = lightCoordinates();
    if (shown == 0) result = vec4(lightDepth(str), 1.0, 0.0, 1.0);
    if (shown == 1) result = vec4(str.z, 1.0, 0.0, 1.0);
    if (shown == 2) result = vec4(shadowVisibility() == 1.0 ? equalColor : shadowedColor, 1.0);
}
