#version 330 core
// From the depths of a map to the moments of their neighbourhood, averaged along a row; average_column.frag does the rest.
#include "shadow_map/moments/moment_depth.glsl"
#include "shadow_map/moments/moments_of_vsm.glsl"
#include "shadow_map/moments/average_values.glsl"
uniform sampler2DArray shadowMap;
uniform int layer, blurRadius;
out vec4 result;

// [anchor: moments-of-a-row]
void main() {
    ivec2 texel = ivec2(gl_FragCoord.xy);
    int side = textureSize(shadowMap, 0).x;
    DistanceRows rows = distanceRows(layer);
    Average average = emptyAverage();
    for (int dx = -blurRadius; dx <= blurRadius; ++dx) {
        ivec2 beside = ivec2(clamp(texel.x + dx, 0, side - 1), texel.y);
        float depth = texelFetch(shadowMap, ivec3(beside, layer), 0).r;
        add(average, momentsOf(momentDepth(rows, (vec2(beside) + 0.5) / float(side), depth)));
    }
    result = meanOf(average);
}
