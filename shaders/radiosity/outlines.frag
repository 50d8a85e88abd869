#version 330 core
// The patches, each in the colour of its level, with its border.
#include "facing.glsl"
#include "radiosity/cell.glsl"
#include "cut_holes.glsl"
in vec3 positionOnMesh;
uniform vec3 lineColor;
uniform float lineWidthPx;
out vec4 result;

void main() {
    vec2 place = placeOnFace(positionOnMesh);
    // Before any branch or discard: derivatives need neighbouring fragments that do the same.
    float metresPerPixel = max(max(length(dFdx(place)), length(dFdy(place))), 1e-30);
    cutHoles();
    uint number = cellAt(place);
    if (number == kNoCell) discard;
    uvec4 cell = entry(cellTable, int(number));
    float offPx = distanceToBorder(cell, place) / metresPerPixel;
    float line = 1.0 - smoothstep(0.5 * lineWidthPx - 0.5, 0.5 * lineWidthPx + 0.5, offPx);
    result = vec4(mix(flatValue(cell).rgb, lineColor, line), 1.0);
}
