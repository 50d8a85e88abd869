// The texture coordinate, by which cut_holes.glsl finds holes; only in the variant of a program that cuts holes.
#ifdef CUT_HOLES
layout(location = 3) in vec2 texcoordMesh; // gl::kTexcoordMesh
out vec2 texcoord;

void passTexcoord() { texcoord = texcoordMesh; }
#else
void passTexcoord() {}
#endif
