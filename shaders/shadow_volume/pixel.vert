#version 330 core
// A point for each pixel of a list, at its centre: covers that pixel alone.
layout(location = 0) in vec2 pixel;  // from the upper left corner of the picture
uniform vec2 pictureSize;            // pixels

void main() {
    vec2 shares = (pixel + 0.5) / pictureSize;
    gl_Position = vec4(2.0 * shares.x - 1.0, 1.0 - 2.0 * shares.y, 0.0, 1.0);
}
