// Depth as moments are taken of it: linear in the distance, from -1 at the map's near side to 1 at its far side. Around zero
// float numbers, and the squares of depths, are finest. Lauritzen, "Summed-Area Variance Shadow Maps", GPU Gems 3, 2007.
uniform mat4 lightViewFromLightClip[6];
uniform vec2 depthRange; // metres along the camera's axis

// The distance is a quotient of two products with the place in clip space. Its rows are taken out of the matrix once, for all
// places of one map.
struct DistanceRows {
    vec4 above, below;
};

DistanceRows distanceRows(int layer) {
    mat4 rows = transpose(lightViewFromLightClip[layer]);
    return DistanceRows(-rows[2], rows[3]);
}

float momentDepth(DistanceRows rows, vec2 uv, float depth) {
    vec4 lightClip = vec4(vec3(uv, depth) * 2.0 - 1.0, 1.0);
    float metres = dot(rows.above, lightClip) / dot(rows.below, lightClip);
    return (metres - depthRange.x) * (2.0 / (depthRange.y - depthRange.x)) - 1.0;
}
