#version 330 core
// One layer of the moments as a picture: in red how much the depths around a texel vary, in metres.
uniform sampler2DArray moments;
uniform int layer;
uniform int cellSize;    // of the sheet this layer is one cell of
uniform vec2 depthRange; // metres that depths of -1 and 1 stand for
out vec4 result;

void main() {
    vec2 uv = mod(gl_FragCoord.xy, float(cellSize)) / float(cellSize);
    vec2 m = textureLod(moments, vec3(uv, float(layer)), 0.0).xy;
    float deviation = sqrt(max(m.y - m.x * m.x, 0.0));
    result = vec4(0.5 * (depthRange.y - depthRange.x) * deviation, 1.0, 0.0, 1.0);
}
