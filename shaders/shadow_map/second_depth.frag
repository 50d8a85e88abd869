#version 330 core
// Keeps what lies behind the first surface: with the depth test LESS the second one is left. Everitt, "Interactive
// Order-Independent Transparency", 2001 (depth peeling).
#include "cut_holes.glsl"
uniform sampler2DArray firstDepth;
uniform float depthEpsilon; // depths: what is nearer than this to the first is the first, rounded

void main() {
    cutHoles();
    if (gl_FragCoord.z <= texelFetch(firstDepth, ivec3(gl_FragCoord.xy, 0), 0).r + depthEpsilon) discard;
}
