// The distance along the light camera's axis, in metres, that a stored depth stands for. A directional light is nowhere:
// its distances count from the near side of the map.
uniform int parallel;
uniform float nearest, farthest;

float distanceOfDepth(float depth) {
    if (parallel == 1) return (farthest - nearest) * depth;
    return nearest * farthest / (farthest - depth * (farthest - nearest));
}
