// The facing gate: true if the side of the triangle that the eye sees faces the light. The sign for the light is decided
// once per triangle in double (techniques/foundation/scene/query/facing.h) and passed on by triangle.glsl.
uniform int mirrored; // 1: the object's matrix turns counter-clockwise into clockwise

#ifdef LIGHTS
flat in uvec2 lightsAtSides;

// A bit for each light that faces the side that the eye sees.
uint lightsAtEyeSide() { return (gl_FrontFacing ? 1 : 0) == mirrored ? lightsAtSides.y : lightsAtSides.x; }
#else
flat in int lightSide;

bool eyeSideFacesLight() {
    // Not written as a comparison of two bools, because Mesa's softpipe compares bools wrongly.
    int outside = mirrored == 1 ? -lightSide : lightSide;
    return gl_FrontFacing ? outside > 0 : outside < 0;
}
#endif
