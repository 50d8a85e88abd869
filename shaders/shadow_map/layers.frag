#version 330 core
// The maps as they lie on what the eye sees: which one answers, by colour, and the squares of its texels.
#include "light.glsl"
#include "facing.glsl"
in vec3 positionView;
#include "shadow_map/lookup.glsl"
uniform vec4 layerColors[6];
uniform float squareTexels; // side of a square; 0: no squares, colours alone
uniform float strength;     // of the colour, over the picture
out vec4 result;

void main() {
    float distanceSquared;
    bool asked = eyeSideFacesLight() && lightShinesTo(towardLight(positionView, distanceSquared));
    MapPlace place = mapPlace();
    bool inside = !place.behind && all(lessThan(abs(place.uv - 0.5), vec2(0.5)));
    if (!asked || !inside) discard;
    vec3 color = mix(layerColors[place.layer], layerColors[min(place.layer + 1, 5)], fadeToNext()).rgb;
    if (squareTexels > 0.0) {
        vec2 square = floor(place.uv * resolution / squareTexels);
        if (mod(square.x + square.y, 2.0) > 0.5) color *= 0.15;
    }
    result = vec4(color, strength);
}
