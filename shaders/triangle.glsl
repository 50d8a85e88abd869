// The number of the triangle, over all objects of the scene, and the side of it that the light is on: one value for all of a
// triangle. Its last vertex belongs to no other and knows the number (gl::MeshBuffers); `flat` takes that vertex's values.
// gl_PrimitiveID would tell the same, but to know it a software renderer takes meshes apart into single triangles, which made
// pictures of large meshes half as fast.
layout(location = 4) in int triangleOfMesh; // gl::kTriangleOfMesh
uniform int triangleBase;                   // scene-wide index of the object's first triangle
uniform isamplerBuffer lightFacing;         // signs decided in double (techniques/foundation/scene/query/facing.h)
flat out int triangleOfScene;
flat out int lightSide;

void passTriangle() {
    triangleOfScene = triangleBase + triangleOfMesh;
    lightSide = texelFetch(lightFacing, triangleOfScene).r;
}
