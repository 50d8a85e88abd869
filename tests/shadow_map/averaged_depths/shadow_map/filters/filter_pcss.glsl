// For tests: what one would do with any other texture, average first and then compare. It means nothing for depths: between a
// caster and the floor there is no surface at the mean of both. (In place of pcss, which reads depths as they are.)
uniform sampler2DArray shadowMap;

float filteredVisibility(MapPlace place) {
    float sum = 0.0;
    for (int dy = -2; dy <= 2; ++dy)
        for (int dx = -2; dx <= 2; ++dx)
            sum += texture(shadowMap, vec3(place.uv + vec2(dx, dy) / resolution, float(place.layer))).r;
    return sum / 25.0 >= referenceDepth(place, vec2(0.0)) ? 1.0 : 0.0;
}
