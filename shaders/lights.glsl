// All lights of a scene, of which light.glsl is asked about one after the other: chooseLight() makes its values those of one of them.
// Set by gl::useForAllLights, which also defines LIGHTS, how many there are, and LIGHT_KINDS, one after the other.
const int lightKinds[LIGHTS] = int[LIGHTS](LIGHT_KINDS);
uniform vec4 lightPositionsView[LIGHTS], lightDirectionsView[LIGHTS], lightIntensities[LIGHTS]; // xyz
uniform vec4 lightCones[LIGHTS]; // half cone, its cosine, edge

int lightKind;
vec3 lightPositionView, lightDirectionView, lightIntensity;
float lightHalfCone, lightCosHalfCone, lightEdge;

void chooseLight(int light) {
    lightKind = lightKinds[light];
    lightPositionView = lightPositionsView[light].xyz;
    lightDirectionView = lightDirectionsView[light].xyz;
    lightIntensity = lightIntensities[light].xyz;
    lightHalfCone = lightCones[light].x;
    lightCosHalfCone = lightCones[light].y;
    lightEdge = lightCones[light].z;
}
