// Depth as moments are taken of it: linear in the distance, from -1 at the map's near side to 1 at its far side. Around zero
// float numbers, and the squares of depths, are finest. Lauritzen, "Summed-Area Variance Shadow Maps", GPU Gems 3, 2007.
#include "shadow_map/distance.glsl"
uniform vec2 depthRange; // metres along the camera's axis

float momentDepth(vec2 uv, float depth, int layer) {
    return 2.0 * (axialDistance(uv, depth, layer) - depthRange.x) / (depthRange.y - depthRange.x) - 1.0;
}
