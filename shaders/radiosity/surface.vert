#version 330 core
// A surface whose fragments know their position on the mesh, by which patches are looked up.
#include "attributes.glsl"
#include "clip_position.glsl"
#include "texcoord.glsl"
#include "triangle.glsl"
uniform mat4 viewFromMesh;
out vec3 positionOnMesh;
out vec3 positionView;

void main() {
    gl_Position = clipPosition(vec4(positionMesh, 1.0));
    passTexcoord();
    passTriangle();
    positionOnMesh = positionMesh;
    positionView = (viewFromMesh * vec4(positionMesh, 1.0)).xyz;
}
