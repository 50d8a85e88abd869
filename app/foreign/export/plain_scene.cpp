// SPDX-License-Identifier: MIT
#include "app/foreign/export/plain_scene.h"

#include <algorithm>
#include <map>
#include <tuple>

#include "app/foreign/export/plain_images.h"
#include "techniques/foundation/scene/load/message_text.h"
#include "techniques/foundation/scene/model/holes.h"
#include "techniques/foundation/scene/model/surface_color.h"
#include "techniques/foundation/scene/query/casters.h"
#include "techniques/foundation/scene/query/coincident/coincident_faces.h"
#include "techniques/foundation/scene/query/outside_camera.h"
#include "techniques/foundation/scene/query/view/depth_fit.h"

namespace shadowlab::foreign {

namespace {

using scene::Bounds;

/// Nought where floats hold the scene where it stands; else the middle of it, in whole metres.
dvec3 originFor(const Bounds& things) {
    // A float of 24 bits then still tells 2^-24 * 256 = 1.5e-5 of the scene's size apart, a hundredth of a pixel.
    constexpr double kFarAway = 256;
    if (things.isEmpty()) return dvec3(0);
    const dvec3 middle = 0.5 * (things.lowerWorld + things.upperWorld);
    if (glm::length(middle) <= kFarAway * glm::length(things.upperWorld - things.lowerWorld)) return dvec3(0);
    return glm::round(middle);
}

PlainEye eyeOf(const scene::Scene& scene, const dvec3& originWorld) {
    const dmat4 viewFromWorld = scene::viewFromWorld(scene.camera);
    const dmat3 worldFromView = glm::transpose(dmat3(viewFromWorld));
    PlainEye eye;
    eye.position = scene.camera.positionWorld - originWorld;
    eye.right = worldFromView[0], eye.up = worldFromView[1], eye.back = worldFromView[2];
    eye.fovYDegrees = scene.camera.fovYDegrees;
    eye.near = scene.camera.near;
    eye.far = scene::farDepth(scene::objectBounds(scene), viewFromWorld, eye.near);
    return eye;
}

/// Materials with what of their images counts: a part without texture coordinates shows none.
class Materials {
public:
    explicit Materials(const scene::Scene& scene) : scene_(scene) {}

    std::uint32_t of(const scene::Object& object, std::size_t part) {
        const std::uint32_t index = object.partMaterials[part];
        const bool hasHoles = scene::maskOfPart(scene_, object, part) != nullptr;
        const bool hasColors = scene::colorImageOfPart(scene_, object, part) != nullptr;
        const auto next = static_cast<std::uint32_t>(plain_.size());
        const auto [entry, isNew] = known_.try_emplace({index, hasHoles, hasColors}, next);
        if (isNew) plain_.push_back(plain(scene_.materials[index], hasHoles, hasColors));
        return entry->second;
    }

    /// From texture coordinates to places in the picture of that material.
    [[nodiscard]] static const scene::ImagePlacement& placement(const scene::Material& material, bool hasHoles) {
        return hasHoles ? material.alphaPlacement : material.colorPlacement;
    }

    void moveInto(PlainScene& scene) {
        scene.materials = std::move(plain_);
        scene.images = images_.take();
        scene.lost.insert(scene.lost.end(), lost_.begin(), lost_.end());
    }
    [[nodiscard]] const PlainMaterial& at(std::uint32_t index) const { return plain_[index]; }

private:
    PlainMaterial plain(const scene::Material& material, bool hasHoles, bool hasColors) {
        PlainMaterial result{material, -1, hasHoles, hasColors, false};
        if (hasHoles && hasColors && !(material.alphaPlacement == material.colorPlacement)) {
            result.hasColors = false; // one picture has one place
            lost_.push_back("the colours of the image of material \"" + material.name +
                            "\", which lies elsewhere than the image that cuts its holes");
        }
        if (result.hasHoles || result.hasColors) {
            result.image = images_.add(result.hasColors ? material.colorImage : nullptr, hasHoles ? material.alphaMask : nullptr);
            result.clamped = placement(material, hasHoles).clamped;
        }
        result.values.alphaMask = nullptr, result.values.colorImage = nullptr;
        result.values.alphaMap.clear(), result.values.diffuseMap.clear();
        return result;
    }

    const scene::Scene& scene_;
    std::map<std::tuple<std::uint32_t, bool, bool>, std::uint32_t> known_;
    std::vector<PlainMaterial> plain_;
    PlainImages images_;
    std::vector<std::string> lost_;
};

/// The triangles of one part, with the vertices that they use.
class PartCopy {
public:
    PartCopy(const scene::Object& object, const dvec3& originWorld)
        : mesh_(*object.mesh), placedFromMesh_(scene::worldFromMesh(object)), mirrored_(scene::isMirrored(object)),
          copied_(object.mesh->positionsMesh.size(), kNone) {
        placedFromMesh_[3] -= dvec4(originWorld, 0.0);
    }

    void fill(PlainMesh& plain, const scene::MeshPart& part, const scene::ImagePlacement* placement, bool withColors) {
        for (std::uint32_t t = part.firstTriangle; t < part.firstTriangle + part.triangleCount; ++t) {
            const uvec3& corners = mesh_.triangles[t];
            uvec3 copy(vertex(plain, corners.x, placement, withColors), vertex(plain, corners.y, placement, withColors),
                       vertex(plain, corners.z, placement, withColors));
            if (mirrored_) std::swap(copy.y, copy.z); // a mirror turns counter-clockwise into clockwise
            plain.triangles.push_back(copy);
        }
        for (std::uint32_t t = part.firstTriangle; t < part.firstTriangle + part.triangleCount; ++t)
            for (int corner = 0; corner < 3; ++corner)
                copied_[mesh_.triangles[t][corner]] = kNone; // the next part has vertices of its own
    }

private:
    static constexpr std::uint32_t kNone = ~std::uint32_t{0};

    std::uint32_t vertex(PlainMesh& plain, std::uint32_t v, const scene::ImagePlacement* placement, bool withColors) {
        if (copied_[v] != kNone) return copied_[v];
        copied_[v] = static_cast<std::uint32_t>(plain.positions.size());
        plain.positions.emplace_back(transformPoint(placedFromMesh_, dvec3(mesh_.positionsMesh[v])));
        plain.normals.emplace_back(transformNormal(placedFromMesh_, dvec3(mesh_.normalsMesh[v])));
        if (placement != nullptr) plain.texcoords.emplace_back(placement->at(dvec2(mesh_.texcoords[v])));
        if (withColors) plain.colors.push_back(mesh_.colors[v]);
        return copied_[v];
    }

    const scene::Mesh& mesh_;
    dmat4 placedFromMesh_;
    bool mirrored_;
    std::vector<std::uint32_t> copied_; ///< of each vertex of the mesh its number in the copy
};

/// What of the scene no format says, because it is not in PlainScene.
std::vector<std::string> lostOf(const scene::Scene& scene) {
    std::vector<std::string> lost;
    const bool anyMoves = std::ranges::any_of(scene.objects, [](const scene::Object& object) { return object.velocityWorld != dvec3(0); });
    if (anyMoves) lost.emplace_back("the motion of objects while the shutter is open; they stand where the scene puts them");
    if (!scene.viewpoints.empty())
        lost.push_back(scene::counted(scene.viewpoints.size(), "further view") + " of the scene; `export --view NAME` takes one as the camera");
    if (scene::CoincidentFaces::of(scene)->mayAnyShowAnother())
        lost.emplace_back("which of two faces in one plane is seen (`shadowlab inspect` lists them): other renderers show now the one, now the other");
    return lost;
}

} // namespace

PlainScene plainScene(const scene::Scene& scene) {
    PlainScene plain;
    plain.name = scene.name;
    plain.lost = lostOf(scene);
    const Bounds things = scene::thingsBounds(scene);
    plain.originWorld = originFor(things);
    if (!things.isEmpty()) plain.lower = things.lowerWorld - plain.originWorld, plain.upper = things.upperWorld - plain.originWorld;
    plain.eye = eyeOf(scene, plain.originWorld);
    plain.ambient = scene.ambient, plain.background = scene.background, plain.exposure = scene.exposure;
    plain.lights = scene.lights;
    for (scene::Light& light : plain.lights)
        if (light.type != scene::LightType::directional) light.positionWorld -= plain.originWorld;

    Materials materials(scene);
    std::vector<std::uint32_t> firstMesh; // of each object
    for (const scene::Object& object : scene.objects) {
        firstMesh.push_back(static_cast<std::uint32_t>(plain.meshes.size()));
        PartCopy copy(object, plain.originWorld);
        for (std::size_t part = 0; part < object.mesh->parts.size(); ++part) {
            PlainMesh mesh;
            mesh.name = object.name;
            mesh.material = materials.of(object, part);
            mesh.castsShadow = object.castsShadow, mesh.receivesShadow = object.receivesShadow;
            mesh.emitterOfLight = object.emitterOfLight;
            mesh.isClosed = object.mesh->outward;
            const PlainMaterial& material = materials.at(mesh.material);
            const scene::Material& source = scene.materials[object.partMaterials[part]];
            const scene::ImagePlacement* placement = material.image < 0 ? nullptr : &Materials::placement(source, material.hasHoles);
            copy.fill(mesh, object.mesh->parts[part], placement, scene::usesVertexColors(scene, object, part));
            if (!mesh.triangles.empty()) plain.meshes.push_back(std::move(mesh));
        }
    }
    firstMesh.push_back(static_cast<std::uint32_t>(plain.meshes.size()));
    for (const scene::Light& light : scene.lights) {
        std::vector<std::uint32_t>& casters = plain.usefulCasters.emplace_back();
        for (const std::size_t object : scene::usefulCasters(scene, light))
            for (std::uint32_t mesh = firstMesh[object]; mesh < firstMesh[object + 1]; ++mesh)
                casters.push_back(mesh);
    }
    materials.moveInto(plain);
    return plain;
}

} // namespace shadowlab::foreign
