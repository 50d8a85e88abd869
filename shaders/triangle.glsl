// The number of the triangle, over all objects of the scene, and the side of it that the light is on: one value per
// triangle. The last vertex of each triangle is its own and has the number (gl::MeshBuffers); `flat` takes the values of
// that vertex. gl_PrimitiveID would give the same number, but a software renderer then splits meshes into single triangles,
// which took twice as long for large meshes.
layout(location = 4) in int triangleOfMesh; // gl::kTriangleOfMesh
uniform int triangleBase;                   // scene-wide index of the object's first triangle
uniform isamplerBuffer lightFacing;         // signs decided in double (techniques/foundation/scene/query/facing.h)
flat out int triangleOfScene;
flat out int lightSide;

void passTriangle() {
    triangleOfScene = triangleBase + triangleOfMesh;
    lightSide = texelFetch(lightFacing, triangleOfScene).r;
}
