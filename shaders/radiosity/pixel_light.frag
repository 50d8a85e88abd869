#version 330 core
// The direct light of one light at each pixel, reflected by the pixel's own material as a Lambertian surface does. Whether the light
// is seen has been found out for each pixel by rays.
//   (none)           the reflected radiance, to be added to what is there
//   VISIBILITY_ONLY  the share of the light that is seen
#include "material.glsl"
#include "light.glsl"
#include "facing.glsl"
#include "shading_normal.glsl"
in vec3 positionView;
in vec3 normalView;
uniform sampler2D shares;   // of each pixel: red the share that is seen; green the irradiance by a light with an area
uniform vec2 sharesPerPixel; // 1; less where blocks of pixels have one share
uniform vec3 areaRadiance;  // of a light with an area, else 0
uniform float exposureFactor;
out vec4 result;

// [anchor: direct-light-of-a-pixel]
void main() {
    float distanceSquared;
    vec3 toLightView = towardLight(positionView, distanceSquared);
    vec2 share = texelFetch(shares, ivec2(gl_FragCoord.xy * sharesPerPixel), 0).rg;
    // Where rasteriser and rays see different surfaces, at their edges, the surface that is drawn may be turned away.
    if (!eyeSideFacesLight() || !lightShinesTo(toLightView)) share.r = 0.0;
#ifdef VISIBILITY_ONLY
    result = vec4(share.r, 1.0, 0.0, 1.0);
#else
    vec3 shadingNormalView = shadingNormal(normalView, positionView);
    vec3 direct = kPi * share.g * areaRadiance;
    if (share.r > 0.0 && areaRadiance == vec3(0.0))
        direct = share.r * irradiance(shadingNormalView, toLightView, distanceSquared);
    result = vec4(exposureFactor * surfaceDiffuse() / kPi * direct, 0.0);
#endif
}
