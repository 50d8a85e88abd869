#version 330 core
// The second half of a square average, along columns.
#include "shadow_map/moments/average_values.glsl"
uniform sampler2D averagedRows;
uniform int blurRadius;
out vec4 result;

void main() {
    ivec2 texel = ivec2(gl_FragCoord.xy);
    int side = textureSize(averagedRows, 0).y;
    Average average = emptyAverage();
    for (int dy = -blurRadius; dy <= blurRadius; ++dy)
        add(average, texelFetch(averagedRows, ivec2(texel.x, clamp(texel.y + dy, 0, side - 1)), 0));
    result = meanOf(average);
}
