// There is one map.
int mapLayer(vec3 pointLightRelative) { return 0; }
float fadeToNext() { return 0.0; }
