#version 330 core
// The value of the patch that the pixel shows: its radiosity, any other number, or the visibility of a light.
#include "material.glsl"
#include "light.glsl"
#include "facing.glsl"
#include "table.glsl"
in vec3 positionView;
flat in int triangleOfScene;
uniform sampler2D divisions;    // three of each triangle of the scene: b and c as functions of positionView; first patch and m
uniform sampler2D values;       // two of each patch: of its front and its back
uniform float factor;           // what they are multiplied with
uniform int showsLights;        // 1: a surface without patches shows its own light; 0: nothing
uniform int receivesShadow;     // 1 or 0
uniform int emittingSides;      // 1: the front of the drawn triangle shines, 2: its back, 3: both
out vec4 result;

// Which of the m x m small triangles: m steps along edge ab, m along ac, and the upper or lower half of that parallelogram.
// [anchor: lecture-place-of-patch]
int placeOfPatch(float b, float c, int m) {
    float along = clamp(b, 0.0, 1.0) * float(m), across = clamp(c, 0.0, 1.0) * float(m);
    int i = min(int(along), m - 1), j = min(int(across), m - 1 - i); // on the border rounding may lead outside
    bool upper = i + j < m - 1 && along - float(i) + across - float(j) > 1.0;
    return i * (2 * m - i) + 2 * j + (upper ? 1 : 0);
}

void main() {
    vec4 division = entry(divisions, 3 * triangleOfScene + 2);
    bool hasPatches = division.y > 0.0;
    vec4 value = vec4(0.0);
    if (hasPatches) {
        float b = dot(entry(divisions, 3 * triangleOfScene), vec4(positionView, 1.0));
        float c = dot(entry(divisions, 3 * triangleOfScene + 1), vec4(positionView, 1.0));
        int patchNumber = int(division.x) + placeOfPatch(b, c, int(division.y));
        bool onFront = gl_FrontFacing != (mirrored == 1);
        value = entry(values, 2 * patchNumber + (onFront ? 0 : 1));
    }
#ifdef VISIBILITY
    float distanceSquared;
    bool gate = eyeSideFacesLight() && lightShinesTo(towardLight(positionView, distanceSquared));
    result = vec4(!gate ? 0.0 : receivesShadow == 0 || !hasPatches ? 1.0 : value.r, 1.0, 0.0, 1.0);
#else
    bool shines = showsLights == 1 && (emittingSides & (gl_FrontFacing ? 1 : 2)) != 0;
    result = hasPatches ? vec4(factor * value.rgb, 1.0) : vec4(shines ? emission : vec3(0.0), 1.0);
#endif
}
