#version 330 core
// Letters, icons and pictures of the window: one texture, tinted.
uniform sampler2D picture;
in vec2 uv;
in vec4 color;
out vec4 shown;

void main() { shown = color * texture(picture, uv); }
