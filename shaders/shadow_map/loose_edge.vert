#version 330 core
// An edge as wide as it takes for every texel it touches to have its centre inside: then the rasteriser, which asks centres
// alone, leaves none out. Its depth is the least that it has within the texel. After Hasselgren, Akenine-Moller and
// Ohlsson, "Conservative Rasterization", GPU Gems 2, 2005.
layout(location = 0) in vec3 fromLightRelative;
layout(location = 1) in vec3 toLightRelative;
uniform mat4 lightClipFromEdges;
uniform float resolution;
uniform float reach; // texels from a centre to the sides of the square around it: half, and a little for rounding

// What of the segment lies within a frame some texels wider than the map, and before the light.
bool clipSegment(inout vec4 a, inout vec4 b) {
    float wide = 1.0 + 8.0 / resolution;
    for (int plane = 0; plane < 5; ++plane) {
        vec4 p = plane == 0   ? vec4(1.0, 0.0, 0.0, wide)
                 : plane == 1 ? vec4(-1.0, 0.0, 0.0, wide)
                 : plane == 2 ? vec4(0.0, 1.0, 0.0, wide)
                 : plane == 3 ? vec4(0.0, -1.0, 0.0, wide)
                              : vec4(0.0, 0.0, 0.0, 1.0);
        float atA = dot(p, a), atB = dot(p, b);
        if (atA <= 0.0 && atB <= 0.0) return false;
        if (atA < 0.0) a = mix(a, b, atA / (atA - atB));
        else if (atB < 0.0) b = mix(b, a, atB / (atB - atA));
    }
    return a.w > 0.0 && b.w > 0.0;
}

void main() {
    vec4 a = lightClipFromEdges * vec4(fromLightRelative, 1.0), b = lightClipFromEdges * vec4(toLightRelative, 1.0);
    gl_Position = vec4(2.0, 2.0, 0.0, 1.0); // outside
    if (!clipSegment(a, b)) return;
    // Texels, and depth -1..1, which is linear along the edge there.
    vec3 aMap = vec3(a.xy / a.w * 0.5 * resolution, a.z / a.w), bMap = vec3(b.xy / b.w * 0.5 * resolution, b.z / b.w);
    vec2 along = bMap.xy - aMap.xy;
    float texels = length(along);
    bool upright = texels <= 1e-6; // along a light ray
    along = upright ? vec2(1.0, 0.0) : along / texels;
    float slope = upright ? 0.0 : (bMap.z - aMap.z) / texels;
    // How far the square reaches along the edge, and the same across it.
    float halfWidth = reach * (abs(along.x) + abs(along.y));
    vec2 corner = vec2((gl_VertexID & 1) == 0 ? -1.0 : 1.0, (gl_VertexID & 2) == 0 ? -1.0 : 1.0);
    vec3 end = corner.x < 0.0 ? aMap : bMap;
    vec2 texel = end.xy + halfWidth * (corner.x * along + corner.y * vec2(-along.y, along.x));
    // The nearest that the edge comes to the light within a texel whose centre this is.
    float nearest = upright ? min(aMap.z, bMap.z) : end.z + slope * corner.x * halfWidth - abs(slope) * 2.0 * halfWidth;
    gl_Position = vec4(texel / (0.5 * resolution), nearest, 1.0);
}
