// The light that comes straight from lights, known at the points of a lattice over each patch: sharper than the patch.
uniform samplerBuffer latticeBoxes; // of each cell: lowest place, and size, of the lattice
uniform samplerBuffer latticeValues;
uniform int latticeSide;            // so many points along each side

// Between the lattice's points, bilinear. What is no patch of its own has no lattice, and its light is in its borders' values.
vec4 lightMapValue(uvec4 cell, vec2 place) {
    if (cell.w == 0u) return vec4(0.0);
    int base = int(cell.w) - 1;
    vec4 box = texelFetch(latticeBoxes, base);
    vec2 at = clamp((place - box.xy) / box.zw, 0.0, 1.0) * float(latticeSide - 1);
    ivec2 corner = min(ivec2(at), ivec2(latticeSide - 2));
    vec2 within = at - vec2(corner);
    int first = (base * latticeSide + corner.y) * latticeSide + corner.x;
    return mix(mix(texelFetch(latticeValues, first), texelFetch(latticeValues, first + 1), within.x),
               mix(texelFetch(latticeValues, first + latticeSide), texelFetch(latticeValues, first + latticeSide + 1), within.x),
               within.y);
}
