#version 330 core
// Every triangle in the colour of its sign of N.L, with a little shape from the viewing angle.
#include "facing.glsl"
in vec3 positionView;
in vec3 normalView;
uniform vec3 towardColor, awayColor;
out vec4 result;

void main() {
    int lightSide = texelFetch(lightFacing, triangleBase + gl_PrimitiveID).r;
    float shape = 0.55 + 0.45 * abs(dot(normalize(normalView), normalize(positionView)));
    result = vec4((lightSide > 0 ? towardColor : awayColor) * shape, 1.0);
}
