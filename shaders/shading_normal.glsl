// The shading normal of a pixel, on the side of the triangle that is seen. Needs facing.glsl.
//
// Near the rim of a round body a smooth normal may lean away from the eye although the triangle's own does not. Were it turned by its own
// sign, it would point into the body, and single pixels of the rim would be lit from behind.
uniform int normalsOnFront; // 1: normals lie before the triangles' fronts; 0: not all of them do, and each is turned to the eye

vec3 shadingNormal(vec3 normalView, vec3 positionView) {
    // In numbers, because Mesa's softpipe chooses wrongly between bools.
    float rasterised = gl_FrontFacing ? 1.0 : -1.0;
    float front = mirrored == 1 ? -rasterised : rasterised;
    float side = normalsOnFront == 1 ? front : -dot(normalView, positionView);
    return side < 0.0 ? -normalize(normalView) : normalize(normalView);
}
