// The number of the triangle, over all objects of the scene, and the side of it that the light is on: one value per
// triangle. The last vertex of each triangle is its own and has the number (gl::MeshBuffers); `flat` takes the values of
// that vertex. gl_PrimitiveID would give the same number, but a software renderer then splits meshes into single triangles,
// which took twice as long for large meshes.
layout(location = 4) in int triangleOfMesh; // gl::kTriangleOfMesh
uniform int triangleBase; // scene-wide index of the object's first triangle
flat out int triangleOfScene;
#ifdef LIGHTS
uniform usamplerBuffer lightsFacing; // of all lights: a bit for each on the side of the front, and of the back
flat out uvec2 lightsAtSides;
#else
uniform isamplerBuffer lightFacing; // signs decided in double (techniques/foundation/scene/query/facing.h)
flat out int lightSide;
#endif

void passTriangle() {
    triangleOfScene = triangleBase + triangleOfMesh;
#ifdef LIGHTS
    lightsAtSides = texelFetch(lightsFacing, triangleOfScene).rg;
#else
    lightSide = texelFetch(lightFacing, triangleOfScene).r;
#endif
}
