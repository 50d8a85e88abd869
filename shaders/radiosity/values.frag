#version 330 core
// The value of the patch that a pixel shows, one for the whole patch or interpolated between its corners. Drawn as radiance
// toward the eye, from a radiosity or an irradiance, or as a plain number.
#include "material.glsl"
#include "light.glsl"
#include "facing.glsl"
#include "radiosity/cell.glsl"
#include "cut_holes.glsl"
in vec3 positionOnMesh;
in vec3 positionView;
uniform int interpolates;
uniform float exposureFactor;
uniform int receivesShadow;
uniform int emittingSides; // 1: the front of the drawn triangle shines, 2: its back, 3: both
out vec4 result;
#ifdef LIGHT_MAP
#include "radiosity/light_map.glsl"
#endif

void main() {
    cutHoles();
    vec2 place = placeOnFace(positionOnMesh);
    uint number = cellAt(place);
    uvec4 cell = number == kNoCell ? uvec4(0u) : entry(cellTable, int(number));
    vec4 value = vec4(0.0);
    if (number != kNoCell) value = interpolates != 0 ? interpolatedValue(cell, place) : flatValue(cell);
#ifdef LIGHT_MAP
    if (number != kNoCell) value += lightMapValue(cell, place);
#endif
#if defined(RADIOSITY) || defined(IRRADIANCE)
    // [anchor: radiosity-shown]
    // What belongs to no patch shows its emission: lights, and surfaces that are never seen.
    vec3 ownRadiance = (emittingSides & (gl_FrontFacing ? 1 : 2)) != 0 ? emission : vec3(0.0);
#ifdef RADIOSITY
    vec3 radiance = number == kNoCell ? ownRadiance : value.rgb / kPi; // of a Lambertian reflector
#else
    // The pixel's own material reflects: the simplified mesh may have another one there.
    vec3 radiance = ownRadiance + surfaceDiffuse() / kPi * value.rgb;
#endif
    result = vec4(exposureFactor * radiance, 1.0);
#elif defined(VISIBILITY)
    float distanceSquared;
    vec3 toLightView = towardLight(positionView, distanceSquared);
    bool gate = eyeSideFacesLight() && lightShinesTo(toLightView);
    result = vec4(!gate ? 0.0 : receivesShadow == 0 ? 1.0 : number == kNoCell ? 0.0 : clamp(value.r, 0.0, 1.0), 1.0, 0.0,
                  1.0); // extrapolated values at a rim may lie outside 0..1
#else
    result = vec4(value.r, number == kNoCell ? 0.0 : 1.0, 0.0, 1.0);
#endif
}
