// The facing gate: does the side of the triangle that the eye sees also face the light? The sign for the light was
// decided once per triangle in double (techniques/foundation/scene/query/facing.h) and is only handed on here (triangle.glsl).
flat in int lightSide;
uniform int mirrored; // 1: the object's matrix turns counter-clockwise into clockwise

bool eyeSideFacesLight() {
    // Written so, and not with a comparison of truth values, because Mesa's softpipe compares them wrongly.
    int outside = mirrored == 1 ? -lightSide : lightSide;
    return gl_FrontFacing ? outside > 0 : outside < 0;
}
