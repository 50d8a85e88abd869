#version 330 core
// A vertex of a shadow volume: where it is, or pushed away from the light: up to a plane, by a distance, or to infinity (w
// = 0). v * l.w - l.xyz points from the light through v, for a point light (l.w = 1) and a directional one (l.w = 0) alike.
// extrudedMesh() in techniques/shadow_volume/count/extrusion.cpp computes the same on the processor.
#include "attributes.glsl"
#include "clip_position.glsl"
layout(location = 2) in float extrudable;
uniform vec4 lightMesh;
uniform vec4 endMesh;           // dot(xyz, v) + w = 0 on the plane where the volume ends; all zero: there is none
uniform float distance;         // metres, where there is no plane; 0: the volume ends at infinity
uniform mat3 worldFromMeshAxes; // for the length of `distance` in the mesh

// [anchor: extrude]
void main() {
    vec3 awayMesh = positionMesh * lightMesh.w - lightMesh.xyz;
    vec4 farMesh = vec4(awayMesh, 0.0);
    if (endMesh.xyz != vec3(0.0)) {
        float toEnd = -(dot(endMesh.xyz, positionMesh) + endMesh.w) / dot(endMesh.xyz, awayMesh);
        farMesh = vec4(positionMesh + toEnd * awayMesh, 1.0);
    } else if (distance > 0.0) {
        float stretch = distance / length(worldFromMeshAxes * awayMesh);
        farMesh = vec4(positionMesh + stretch * awayMesh, 1.0);
    }
    gl_Position = clipPosition(extrudable > 0.5 ? farMesh : vec4(positionMesh, 1.0));
}
