// The distance along the light camera's axis, in metres, that a depth at a place in the map stands for. A directional light
// is nowhere: its distances count from the near side of the map.
uniform mat4 lightViewFromLightClip[6];
uniform float distanceStart; // metres: where distances count from

float distanceOf(vec2 uv, float depth, int layer) {
    vec4 positionLightView = lightViewFromLightClip[layer] * vec4(vec3(uv, depth) * 2.0 - 1.0, 1.0);
    return -positionLightView.z / positionLightView.w - distanceStart;
}
