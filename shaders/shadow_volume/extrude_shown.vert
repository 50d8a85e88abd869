#version 330 core
// A vertex of a shadow volume for the picture of it: pushed away from the light by a finite stretch, so that its end can be
// seen. The counting uses extrude.vert, which goes to infinity.
#include "attributes.glsl"
#include "clip_position.glsl"
layout(location = 2) in float extrudable;
uniform vec4 lightMesh;
uniform float shownStretch; // in units of the way from the light to the vertex; for a directional light in metres

void main() {
    vec3 awayMesh = positionMesh * lightMesh.w - lightMesh.xyz;
    gl_Position = clipPosition(vec4(positionMesh + extrudable * shownStretch * awayMesh, 1.0));
}
