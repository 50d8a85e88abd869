// From one triangle of a surface to the next, along a line in the map. The surface is the light's picture of one mesh, in
// texels; where no loose edge is near, its triangles lie side by side there, and each point belongs to one of them.
#include "table.glsl"
uniform sampler2D positionsLightRelative;
uniform usampler2D triangles; // two texels each: numbers of corners and 1 where there may be
                                 // holes; numbers of the triangles beyond the edges after the corners

const uint kNoTriangle = 0xffffffffu;
const int kMostSteps = 24;

// A corner near the plane of the light is far outside of the map, where float cannot tell texels apart: within these bounds,
// of texels and of the map's range, rounding is a five-hundredth of a texel and a millionth of the range.
const float kFarthestCorner = 8192.0, kDeepestCorner = 4.0;

struct MapTriangle {
    vec3 corners[3]; // texels from where the walk starts, and depth (0..1)
    bool beforeLight; // all of it, and well enough known
    bool mayHaveHoles;
};

MapTriangle mapTriangle(uint triangle, int layer, vec2 startTexel) {
    uvec4 vertices = entry(triangles, 2 * int(triangle));
    MapTriangle result;
    result.beforeLight = true;
    result.mayHaveHoles = vertices.w == 1u;
    for (int i = 0; i < 3; ++i) {
        vec4 lightClip = lightClipFromLightRelative[layer] * entry(positionsLightRelative, int(vertices[i]));
        vec3 place = lightClip.xyz / lightClip.w * 0.5 + 0.5;
        result.corners[i] = vec3(place.xy * resolution - startTexel, place.z);
        bool known = lightClip.w > 0.0 && all(lessThan(abs(result.corners[i].xy), vec2(kFarthestCorner))) &&
                     abs(place.z) < kDeepestCorner;
        if (!known) result.beforeLight = false;
    }
    return result;
}

float cross2(vec2 a, vec2 b) { return a.x * b.y - a.y * b.x; }

// How far a point is inside each of the triangle's edges, in texels; negative outside.
vec3 insideOfEdges(MapTriangle t, vec2 point) {
    vec2 a = t.corners[0].xy, b = t.corners[1].xy, c = t.corners[2].xy;
    float winding = cross2(b - a, c - a) < 0.0 ? -1.0 : 1.0;
    return winding * vec3(cross2(b - a, point - a) / length(b - a), cross2(c - b, point - b) / length(c - b),
                          cross2(a - c, point - c) / length(a - c));
}

// Depth of the triangle's plane at a point, and how steep it is: the sum of what it changes by per texel in both
// directions, without signs.
vec2 depthAndSlopeAt(MapTriangle t, vec2 point) {
    vec3 u = t.corners[1] - t.corners[0], v = t.corners[2] - t.corners[0];
    float area = cross2(u.xy, v.xy);
    vec2 slope = vec2(u.z * v.y - v.z * u.y, v.z * u.x - u.z * v.x) / area;
    return vec2(t.corners[0].z + dot(slope, point - t.corners[0].xy), abs(slope.x) + abs(slope.y));
}

struct WalkEnd {
    bool arrived;   // false: the surface ends or turns over on the way, or the walk was not certain of it
    uint triangle;  // which one is at the end
    float inside;   // texels: how far the end is from its edges
    vec2 depth;     // of it there, and its slope
    float farthest; // depth of the surface where it is farthest from the light on the way
};
const WalkEnd kLost = WalkEnd(false, kNoTriangle, 0.0, vec2(0.0), 0.0);

// Walks from a triangle, which holds the start, in a straight line to `toTexel` (texels from the start).
WalkEnd walk(uint triangle, int layer, vec2 startTexel, vec2 toTexel) {
    uint before = kNoTriangle;
    float firstWinding = 0.0, farthest = 0.0;
    for (int step = 0; step < kMostSteps; ++step) {
        MapTriangle t = mapTriangle(triangle, layer, startTexel);
        float winding = cross2(t.corners[1].xy - t.corners[0].xy, t.corners[2].xy - t.corners[0].xy);
        if (step == 0) firstWinding = winding;
        if (!t.beforeLight || !(winding * firstWinding > 0.0)) return kLost; // folded back: beyond a silhouette
        vec3 inside = insideOfEdges(t, toTexel);
        float least = min(inside.x, min(inside.y, inside.z));
        if (least >= 0.0) {
            vec2 depth = depthAndSlopeAt(t, toTexel);
            return WalkEnd(true, triangle, least, depth, max(farthest, depth.x));
        }
        uvec3 neighbours = entry(triangles, 2 * int(triangle) + 1).xyz;
        uint next = kNoTriangle;
        for (int i = 0; i < 3; ++i) {
            // Out through the edge that the end is beyond, and that the line crosses.
            vec2 from = t.corners[i].xy, to = t.corners[(i + 1) % 3].xy;
            bool crosses = cross2(toTexel, from) * cross2(toTexel, to) <= 0.0;
            if (!(inside[i] < 0.0) || !crosses || neighbours[i] == before) continue;
            next = neighbours[i];
            vec2 place = toTexel * clamp(cross2(from, to - from) / cross2(toTexel, to - from), 0.0, 1.0);
            farthest = max(farthest, depthAndSlopeAt(t, place).x);
        }
        if (next == kNoTriangle) return kLost;
        before = triangle;
        triangle = next;
    }
    return kLost;
}
