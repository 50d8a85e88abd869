// There is one map: the vertex shader has put the point into it.
in vec4 positionLightClip;

int mapLayer(vec3 pointLightRelative) { return 0; }
float fadeToNext() { return 0.0; }

vec4 lightClipIn(int layer) { return positionLightClip; }
// Before main(), as those of the point itself (lookup.glsl).
LightSteps stepsOfPixel = LightSteps(dFdx(positionLightClip), dFdy(positionLightClip));
LightSteps lightStepsIn(int layer) { return stepsOfPixel; }
