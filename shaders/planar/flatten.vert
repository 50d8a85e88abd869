#version 330 core
// A caster's vertex where its shadow falls on a plane (techniques/planar/projection.h). The position stays homogeneous,
// because at the light's height its weight is 0: a point at infinity.
#include "attributes.glsl"
#include "texcoord.glsl"
uniform mat4 clipFromMeshFlattened; // clip space from mesh (or caster) space, by way of the plane
uniform vec4 weightRow;             // times the vertex: the weight of its shadow, 0 at the light's height
uniform vec4 heightRow;             // times the vertex: its height above the plane
uniform float sheet;                // -1 inverts all signs: the same points, but those with negative w become visible
out float gl_ClipDistance[2];
#ifdef DIVIDE
uniform mat4 viewFromMeshFlattened;
uniform mat4 clipFromView;
#endif

// [anchor: flatten]
void main() {
    vec4 homogeneousMesh = vec4(positionMesh, 1.0);
#ifdef DIVIDE
    // As on paper: the position itself, in metres, with a weight of 1. Between two vertices only positions are then
    // interpolated.
    vec4 flattenedView = viewFromMeshFlattened * homogeneousMesh;
    gl_Position = clipFromView * vec4(flattenedView.xyz / flattenedView.w, 1.0);
#else
    gl_Position = sheet * (clipFromMeshFlattened * homogeneousMesh);
#endif
    passTexcoord();
    gl_ClipDistance[0] = dot(weightRow, homogeneousMesh);
    gl_ClipDistance[1] = dot(heightRow, homogeneousMesh);
}
