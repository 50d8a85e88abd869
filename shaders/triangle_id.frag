#version 330 core
// Which triangle is seen in this pixel: its number over all objects of the scene.
uniform int triangleBase; // scene-wide index of the first triangle of this draw call
out uint triangle;

void main() { triangle = uint(triangleBase + gl_PrimitiveID); }
