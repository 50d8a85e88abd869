// The direct light, known at the points of a lattice over each patch: sharper than the patches.
#include "table.glsl"
uniform sampler2D lattices; // two entries per patch: lower corner and size; first point, and how many along u and v
uniform sampler2D latticeValues;

// Bilinear between the lattice's points. Cells that are no patch have no lattice; their direct light is in the values of their
// borders.
vec4 lightMapValue(uvec4 cell, vec2 place) {
    if (cell.w == 0u) return vec4(0.0);
    vec4 box = entry(lattices, 2 * int(cell.w) - 2), table = entry(lattices, 2 * int(cell.w) - 1);
    ivec2 count = ivec2(table.yz);
    vec2 at = clamp((place - box.xy) / box.zw, 0.0, 1.0) * vec2(count - 1);
    ivec2 corner = min(ivec2(at), count - 2);
    vec2 within = at - vec2(corner);
    int lower = int(table.x) + corner.y * count.x + corner.x, upper = lower + count.x;
    return mix(mix(entry(latticeValues, lower), entry(latticeValues, lower + 1), within.x),
               mix(entry(latticeValues, upper), entry(latticeValues, upper + 1), within.x), within.y);
}
