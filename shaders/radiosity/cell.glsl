// The patch that a fragment shows, and its value there. The tables are made in techniques/radiosity/display/surface_cells.h.
#include "table.glsl"
uniform sampler2D cellPlaces;
uniform usampler2D cellRoots;
uniform sampler2D cellLines;
uniform usampler2D cellBranches;
uniform usampler2D cellTable;
uniform sampler2D cellBorders;
uniform sampler2D patchValues;
uniform sampler2D borderValues;
flat in int triangleOfScene;

const uint kLeaf = 0x80000000u;
const uint kNoCell = 0xffffffffu;

// Metres in the plane of the face.
vec2 placeOnFace(vec3 positionOnMesh) {
    int first = 2 * triangleOfScene;
    vec4 position = vec4(positionOnMesh, 1.0);
    return vec2(dot(entry(cellPlaces, first), position), dot(entry(cellPlaces, first + 1), position));
}

// The cell at a place, or kNoCell.
uint cellAt(vec2 place) {
    uvec4 roots = entry(cellRoots, triangleOfScene);
    uint next = gl_FrontFacing ? roots.x : roots.y;
    while ((next & kLeaf) == 0u) {
        vec4 line = entry(cellLines, int(next));
        uvec4 branches = entry(cellBranches, int(next));
        next = dot(line.xy, place) + line.z > 0.0 ? branches.x : branches.y;
    }
    return next == kNoCell ? kNoCell : next & ~kLeaf;
}

float cross2(vec2 a, vec2 b) { return a.x * b.y - a.y * b.x; }

// One value for all of the patch.
vec4 flatValue(uvec4 cell) { return entry(patchValues, int(cell.x)); }

// Linear over each triangle of the fan from the cell's centre to its border; equal from both sides along a border.
vec4 interpolatedValue(uvec4 cell, vec2 place) {
    int first = int(cell.y), corners = int(cell.z);
    vec4 centre = entry(cellBorders, first);
    vec4 a = entry(cellBorders, first + corners);
    float bestInside = -1e30;
    vec4 best = entry(borderValues, int(centre.z));
    for (int i = 1; i <= corners; ++i) {
        vec4 b = entry(cellBorders, first + i);
        vec2 toA = a.xy - centre.xy, toB = b.xy - centre.xy, toHere = place - centre.xy;
        float area = cross2(toA, toB);
        vec2 weights = area == 0.0 ? vec2(-1e30) : vec2(cross2(toHere, toB), cross2(toA, toHere)) / area;
        float inside = min(weights.x, weights.y);
        if (inside > bestInside) { // by rounding, a place may lie in none
            bestInside = inside;
            weights = max(weights, 0.0) / max(1.0, weights.x + weights.y);
            best = (1.0 - weights.x - weights.y) * entry(borderValues, int(centre.z)) +
                   weights.x * entry(borderValues, int(a.z)) + weights.y * entry(borderValues, int(b.z));
        }
        a = b;
    }
    return best;
}

// How far the place lies from the border of its cell, in metres.
float distanceToBorder(uvec4 cell, vec2 place) {
    int first = int(cell.y), corners = int(cell.z);
    vec2 a = entry(cellBorders, first + corners).xy;
    float nearest = 1e30;
    for (int i = 1; i <= corners; ++i) {
        vec2 b = entry(cellBorders, first + i).xy;
        nearest = min(nearest, abs(cross2(b - a, place - a)) / max(length(b - a), 1e-30));
        a = b;
    }
    return nearest;
}
