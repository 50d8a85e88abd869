// SPDX-License-Identifier: MIT
#include "techniques/foundation/scene/model/holes.h"

#include <algorithm>

#include "techniques/foundation/scene/load/message_text.h"

namespace shadowlab::scene {

const AlphaMask* maskOfPart(const Scene& scene, const Object& object, std::size_t part) {
    return object.mesh->parts[part].hasTexcoords ? scene.materials[object.partMaterials[part]].alphaMask.get()
                                                 : nullptr;
}

bool hasHoles(const Scene& scene, const Object& object) {
    for (std::size_t part = 0; part < object.mesh->parts.size(); ++part)
        if (maskOfPart(scene, object, part)) return true;
    return false;
}

bool isInHole(const Scene& scene, const Object& object, std::uint32_t triangle, const dvec3& barycentric) {
    const Mesh& mesh = *object.mesh;
    const auto after = std::ranges::upper_bound(mesh.parts, triangle, {}, &MeshPart::firstTriangle);
    const AlphaMask* mask = maskOfPart(scene, object, static_cast<std::size_t>(after - mesh.parts.begin() - 1));
    if (!mask) return false;
    const uvec3& corners = mesh.triangles[triangle];
    dvec2 texcoord(0.0);
    for (int corner = 0; corner < 3; ++corner)
        texcoord += barycentric[corner] * dvec2(mesh.texcoords[corners[corner]]);
    return mask->isHole(texcoord);
}

std::string noteOnWholePart(const Material& material, const MeshPart& part) {
    if (!material.alphaMask || part.hasTexcoords) return "";
    return "material '" + shown(material.name) + "': no holes are cut in " + counted(part.triangleCount, "triangle") +
           " without texture coordinates (vt)";
}

} // namespace shadowlab::scene
