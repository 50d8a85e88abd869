// There is one map, and the point comes in world space.
int mapLayer(vec3 pointLightRelative) { return 0; }
float fadeToNext() { return 0.0; }

vec4 lightClipIn(int layer) { return lightClipFromLightRelative[0] * vec4(positionLightRelative, 1.0); }
LightSteps lightStepsIn(int layer) {
    return LightSteps(lightClipFromLightRelative[0] * vec4(rightLightRelative, 0.0),
                      lightClipFromLightRelative[0] * vec4(upLightRelative, 0.0));
}
