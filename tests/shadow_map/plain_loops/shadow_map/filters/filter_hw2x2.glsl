// For tests: four comparisons, each texel by itself and at its centre, weighted in the shader: what the sampler of
// shaders/shadow_map/filters/filter_hw2x2.glsl does in one lookup. The depth that they are compared with is chosen as there.
uniform sampler2DArrayShadow shadowMap;

float filteredVisibility(MapPlace place) {
    vec2 texel = place.uv * resolution - 0.5, lower = floor(texel), share = texel - lower;
    float depth = 1.0;
    for (int i = 0; i < 4; ++i)
        depth = min(depth, referenceDepth(place, (lower + vec2(i & 1, i >> 1) + 0.5) / resolution - place.uv));
    float lit = 0.0;
    for (int i = 0; i < 4; ++i) {
        vec2 corner = vec2(i & 1, i >> 1), weights = mix(1.0 - share, share, corner);
        float answer = texture(shadowMap, vec4((lower + corner + 0.5) / resolution, float(place.layer), depth));
        lit += weights.x * weights.y * floor(answer + 0.5); // yes or no
    }
    return lit;
}
