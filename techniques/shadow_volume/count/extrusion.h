// How the vertices of a caster are pushed away from a light: the uniforms of extrude.vert, and the same computation on the
// processor. Both give the same pixels, so a lesson can compare their speed.
// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "techniques/foundation/gl/program.h"
#include "techniques/shadow_volume/count/volume_end.h"

namespace shadowlab::shadow_volume {

/// In the mesh's own space, in single precision as the shader has them.
struct Extrusion {
    vec4 lightMesh{0.0f};         ///< homogeneous; w = 0: the direction toward the light
    vec4 endMesh{0.0f};           ///< dot(xyz, v) + w = 0 on the plane where the volume ends; all zero: there is none
    float distance = 0;           ///< metres, where there is no plane; 0: the volume ends at infinity
    mat3 worldFromMeshAxes{1.0f}; ///< for the length of `distance` in the mesh
    friend bool operator==(const Extrusion&, const Extrusion&) = default;
};
Extrusion extrusionOf(const scene::Object& object, const scene::Light& light, const VolumeEnd& end);

/// For extrude.vert.
void setExtrusion(const gl::Program& program, const Extrusion& extrusion);

/// The mesh's vertices as they are, then once more, pushed: homogeneous, in the numbering of Volume (volume.h).
std::vector<vec4> extrudedMesh(const scene::Mesh& mesh, const Extrusion& extrusion);

} // namespace shadowlab::shadow_volume
