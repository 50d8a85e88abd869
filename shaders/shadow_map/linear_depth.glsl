// The distance along the light camera's axis, in metres, that a stored depth stands for.
uniform int parallel;
uniform float nearest, farthest;

float distanceOfDepth(float depth) {
    if (parallel == 1) return mix(nearest, farthest, depth);
    return nearest * farthest / (farthest - depth * (farthest - nearest));
}
