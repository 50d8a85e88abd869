// Of several maps along the view, the first that reaches as far from the eye as the point is.
uniform int cascades;
uniform vec4 cascadeEnds; // metres along the eye's axis
uniform vec4 fadeStarts;  // where each begins to fade into the next

int mapLayer(vec3 pointLightRelative) {
    int layer = 0;
    while (layer < cascades - 1 && -positionView.z > cascadeEnds[layer]) ++layer;
    return layer;
}

// The share that the next cascade has in the answer.
float fadeToNext() {
    int layer = mapLayer(vec3(0.0));
    if (layer == cascades - 1) return 0.0;
    float width = max(cascadeEnds[layer] - fadeStarts[layer], 1e-9);
    return clamp((-positionView.z - fadeStarts[layer]) / width, 0.0, 1.0);
}

vec4 lightClipIn(int layer) { return lightClipFromLightRelative[layer] * vec4(positionLightRelative, 1.0); }
LightSteps lightStepsIn(int layer) {
    return LightSteps(lightClipFromLightRelative[layer] * vec4(rightLightRelative, 0.0),
                      lightClipFromLightRelative[layer] * vec4(upLightRelative, 0.0));
}
