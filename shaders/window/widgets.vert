#version 330 core
// A corner of a widget: places are pixels from the window's upper left corner, colours are as they are shown.
layout(location = 0) in vec2 positionPixels;
layout(location = 1) in vec2 cornerUv;
layout(location = 2) in vec4 cornerColor;
uniform vec2 windowPixels;
out vec2 uv;
out vec4 color;

void main() {
    uv = cornerUv;
    color = cornerColor;
    vec2 share = positionPixels / windowPixels;
    gl_Position = vec4(2.0 * share.x - 1.0, 1.0 - 2.0 * share.y, 0.0, 1.0);
}
