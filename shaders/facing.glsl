// The facing gate: does the side of the triangle that the eye sees also face the light? The sign for the light was
// decided once per triangle in double (techniques/foundation/scene/facing.h) and is only looked up here.
uniform isamplerBuffer lightFacing;
uniform int triangleBase; // scene-wide index of the first triangle of this draw call
uniform int mirrored;     // 1: the object's matrix turns counter-clockwise into clockwise

bool eyeSideFacesLight() {
    int lightSide = texelFetch(lightFacing, triangleBase + gl_PrimitiveID).r;
    // Written so, and not with a comparison of truth values, because Mesa's softpipe compares them wrongly.
    if (mirrored == 1) lightSide = -lightSide;
    return gl_FrontFacing ? lightSide > 0 : lightSide < 0;
}
