#version 330 core
// The kernel of one pixel, drawn where it lies on the visible surfaces: which texels are read, and what each comparison says.
#include "light.glsl"
#include "facing.glsl"
in vec3 positionView;
#include "shadow_map/lookup.glsl"
uniform sampler2DArray shadowMap;
uniform int kernelLayer;
uniform vec2 kernelUv;       // its middle
uniform vec2 kernelX, kernelY; // rows of the matrix that takes it to a square from -1 to 1, or to a disc
uniform int kernelIsRound;
uniform vec3 kernelPlane;    // of the point that it is for: the depth it compares with, and how that varies
uniform vec2 kernelPixel;    // for which it is
uniform vec3 litColor, occludedColor, pixelColor;
out vec4 result;

// Pixels around the one it is for that are marked.
const float kMark = 2.5;

void main() {
    MapPlace place = mapPlace();
    vec2 offsetUv = place.uv - kernelUv, within = vec2(dot(kernelX, offsetUv), dot(kernelY, offsetUv));
    bool inside = place.layer == kernelLayer && !place.behind &&
                  (kernelIsRound == 1 ? length(within) <= 1.0 : max(abs(within.x), abs(within.y)) <= 1.0);
    bool marked = distance(gl_FragCoord.xy, kernelPixel) < kMark;
    if (!inside && !marked) discard;
    float stored = texture(shadowMap, vec3(place.uv, float(place.layer))).r;
    vec3 answer = stored < kernelPlane.x + dot(kernelPlane.yz, offsetUv) ? occludedColor : litColor;
    // Neighbouring texels are told apart by their brightness.
    vec2 texel = floor(place.uv * resolution);
    result = vec4(marked ? pixelColor : answer * (mod(texel.x + texel.y, 2.0) > 0.5 ? 0.55 : 1.0), 0.8);
}
