// What images laid on a surface, and colours of its vertices, are found by; only in the variants of a program that ask for them.
#if defined(CUT_HOLES) || defined(COLORED)
layout(location = 3) in vec2 texcoordMesh; // gl::kTexcoordMesh
out vec2 texcoord;
#endif
#ifdef COLORED
layout(location = 5) in vec3 colorMesh; // gl::kColorMesh: linear RGB
out vec3 vertexColor;
#endif

void passTexcoord() {
#if defined(CUT_HOLES) || defined(COLORED)
    texcoord = texcoordMesh;
#endif
#ifdef COLORED
    vertexColor = colorMesh;
#endif
}
