#version 330 core
// The depth map as a picture: green is 1 where the light sees anything.
uniform sampler2DArray depthMap;
uniform vec2 size; // of the picture, in pixels
out vec4 result;

void main() {
    float d = texture(depthMap, vec3(gl_FragCoord.xy / size, 0.0)).r;
    result = vec4(d, d < 1.0 ? 1.0 : 0.0, 0.0, 1.0);
}
