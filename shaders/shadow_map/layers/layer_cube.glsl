// Of the six maps around a light, the one that looks along the largest component. All six compare depths along their own
// axis, and each is a little wider than its share, so where two meet both would give the same answer: there is no seam.
int mapLayer(vec3 pointLightRelative) {
    vec3 size = abs(pointLightRelative);
    if (size.x >= size.y && size.x >= size.z) return pointLightRelative.x > 0.0 ? 0 : 1;
    if (size.y >= size.z) return pointLightRelative.y > 0.0 ? 2 : 3;
    return pointLightRelative.z > 0.0 ? 4 : 5;
}
float fadeToNext() { return 0.0; }

vec4 lightClipIn(int layer) { return lightClipFromLightRelative[layer] * vec4(positionLightRelative, 1.0); }
LightSteps lightStepsIn(int layer) {
    return LightSteps(lightClipFromLightRelative[layer] * vec4(rightLightRelative, 0.0),
                      lightClipFromLightRelative[layer] * vec4(upLightRelative, 0.0));
}
