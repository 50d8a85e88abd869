#version 330 core
// A surface as the eye sees it: position for the rasteriser, position and normal in view space for shading, and position
// relative to the light (world axes, origin at the light) and in the clip space of a camera there, for shadow maps; and in
// world space, whose floats are too coarse far from the origin, so that this error can be shown. The linker removes outputs
// that the fragment shader does not read.
#include "attributes.glsl"
#include "clip_position.glsl"
#include "texcoord.glsl"
#include "triangle.glsl"
uniform mat4 viewFromMesh;
uniform mat3 normalViewFromMesh;
uniform bool stretchesNormals; // the scale is not the same along all axes
uniform mat4 lightRelativeFromMesh;
uniform mat4 lightClipFromMesh;
uniform mat4 worldFromMesh;
out vec3 positionView;
out vec3 normalView;
out vec3 positionLightRelative;
out vec4 positionLightClip;
out vec3 positionWorld;

void main() {
    gl_Position = clipPosition(vec4(positionMesh, 1.0));
    passTexcoord();
    passTriangle();
    positionView = (viewFromMesh * vec4(positionMesh, 1.0)).xyz;
    normalView = normalViewFromMesh * normalMesh;
    // Between normals of different lengths the longer one would count for more.
    if (stretchesNormals) normalView = normalize(normalView);
    positionLightRelative = (lightRelativeFromMesh * vec4(positionMesh, 1.0)).xyz;
    positionLightClip = lightClipFromMesh * vec4(positionMesh, 1.0);
    positionWorld = (worldFromMesh * vec4(positionMesh, 1.0)).xyz;
}
