// What a fragment needs to know whether it lies in a hole (cut_holes.glsl); nothing where nothing has holes.
#ifdef CUT_HOLES
layout(location = 3) in vec2 texcoordMesh; // gl::kTexcoordMesh
out vec2 texcoord;

void passTexcoord() { texcoord = texcoordMesh; }
#else
void passTexcoord() {}
#endif
