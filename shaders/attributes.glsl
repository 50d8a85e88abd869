// Vertex attributes that every surface has; the numbers are those of gl::Attribute in techniques/foundation/gl/scene/scene_buffers.h.
layout(location = 0) in vec3 positionMesh;
layout(location = 1) in vec3 normalMesh;
