#version 330 core
// One layer of the map as a picture: distance in red, 1 in green where the light saw anything.
#include "shadow_map/distance.glsl"
uniform sampler2DArray shadowMap;
uniform int layer;
uniform int cellSize; // of the sheet this layer is one cell of
out vec4 result;

void main() {
    vec2 uv = mod(gl_FragCoord.xy, float(cellSize)) / float(cellSize);
    float depth = texture(shadowMap, vec3(uv, float(layer))).r;
    result = vec4(distanceOf(uv, depth, layer), depth < 1.0 ? 1.0 : 0.0, 0.0, 1.0);
}
