#version 330 core
// A vertex of a shadow volume: where it is, or pushed away from the light to infinity.
#include "attributes.glsl"
#include "clip_position.glsl"
#include "texcoord.glsl"
layout(location = 2) in float extrudable; // 1: it is one that is pushed
uniform vec4 lightMesh; // homogeneous: w = 1 and its place, or w = 0 and the direction toward it

void main() {
    // === BLANK 5: the extrusion. A point at infinity has w = 0, and the direction in which it lies for x, y and z: away from the
    // light, which for both kinds of light is positionMesh * lightMesh.w - lightMesh.xyz. As it is, the point stays where it is,
    // and volumes are flat. When it is right, shadows reach everything behind their casters.
    vec4 farMesh = vec4(positionMesh, 1.0);
    // === END OF BLANK 5
    gl_Position = clipPosition(extrudable > 0.5 ? farMesh : vec4(positionMesh, 1.0));
    passTexcoord();
}
