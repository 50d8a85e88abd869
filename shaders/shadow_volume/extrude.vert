#version 330 core
// A vertex of a shadow volume: where it is, or pushed away from the light to infinity (w = 0).
// v * l.w - l.xyz points from the light through v, for a point light (l.w = 1) and a directional one (l.w = 0) alike.
#include "attributes.glsl"
#include "clip_position.glsl"
layout(location = 2) in float extrudable;
uniform vec4 lightMesh;

void main() {
    vec4 atInfinityMesh = vec4(positionMesh * lightMesh.w - lightMesh.xyz, 0.0);
    gl_Position = clipPosition(extrudable > 0.5 ? atInfinityMesh : vec4(positionMesh, 1.0));
}
