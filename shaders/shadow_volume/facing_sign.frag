#version 330 core
// Every triangle in the colour of its sign of N.L, with a little shape from the viewing angle.
flat in int lightSide;
in vec3 positionView;
in vec3 normalView;
uniform vec3 towardColor, awayColor;
out vec4 result;

void main() {
    float shape = 0.55 + 0.45 * abs(dot(normalize(normalView), normalize(positionView)));
    result = vec4((lightSide > 0 ? towardColor : awayColor) * shape, 1.0);
}
