// A scene around a bare mesh: floor, key light and camera, all in proportion to the size of the mesh.
// SPDX-License-Identifier: MIT
#include "techniques/foundation/scene/obj/stage.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>

#include <glm/gtc/constants.hpp>

#include "techniques/foundation/scene/load/load.h"
#include "techniques/foundation/scene/load/message_text.h"
#include "techniques/foundation/scene/obj/common_vertices.h"
#include "techniques/foundation/scene/query/topology/outward_parts.h"

namespace shadowlab::scene {

double largestExtent(const Bounds& bounds) {
    const dvec3 extent = bounds.upperWorld - bounds.lowerWorld;
    return glm::max(extent.x, glm::max(extent.y, extent.z));
}

dvec3 ontoStage(const Bounds& bounds) {
    const double size = largestExtent(bounds);
    // A sheet or a needle lying flat would hide its own shadow: it floats a little.
    const bool isFlat = bounds.upperWorld.y - bounds.lowerWorld.y < 0.02 * size;
    const double lift = isFlat ? 0.3 * size : 0.0;
    const dvec3 centre = 0.5 * (bounds.lowerWorld + bounds.upperWorld);
    return {-centre.x, lift - bounds.lowerWorld.y, -centre.z};
}

Stage stageAround(const Bounds& meshWorld, double size) {
    Stage stage{.meshWorld = meshWorld, .size = size};
    // Just under the mesh: 1/1024 of its size is too little to see and enough for a 24-bit depth buffer to tell a flat
    // underside from the floor at the distance of this camera.
    stage.floorWorld = -stage.size / 1024.0;
    return stage;
}

Object floorUnder(const Stage& stage) {
    Object floor;
    floor.name = "floor";
    const double extent = 40.0 * stage.size; // reaches the horizon of this camera
    floor.mesh = std::make_shared<const Mesh>(makeQuad({extent, extent}));
    floor.source.shape = "quad " + numberText(extent) + " " + numberText(extent);
    floor.source.material = "floor";
    floor.source.translateWorld = dvec3(0.0, stage.floorWorld, 0.0);
    floor.worldFromObject[3] = dvec4(floor.source.translateWorld, 1.0);
    return floor;
}

/// Above, left and in front, as a photographer's key light: the shadow falls to the right and back, in full view.
Light keyLight(const Stage& stage) {
    Light light;
    light.name = "key";
    const dvec3 toLightWorld = glm::normalize(dvec3(-0.5, 1.2, 0.5)); // about 60 degrees high: a compact shadow
    const double distance = 6.0 * stage.size; // so far that the floor about the mesh is lit evenly
    light.positionWorld = 0.5 * (stage.meshWorld.lowerWorld + stage.meshWorld.upperWorld) + distance * toLightWorld;
    // Irradiance 3 makes a white surface that faces the light just not clip (3 * 0.8 / pi = 0.76).
    light.intensity = 3.0 * distance * distance;
    return light;
}

namespace {

/// Across one axis of the picture: how far back a camera of fixed direction has to stand so that all points appear
/// within `slope` (their offset over their depth) of its centre. Exact: two planes of that slope are moved in until
/// they touch the points, and the camera stands where they meet.
class AxisFit {
public:
    explicit AxisFit(double slope) : slope_(slope) {}
    void include(double offset, double backward) {
        high_ = glm::max(high_, offset + slope_ * backward);
        low_ = glm::max(low_, slope_ * backward - offset);
    }
    double centre() const { return 0.5 * (high_ - low_); }
    double distance() const { return 0.5 * (high_ + low_) / slope_; }
    /// The centre nearest to the wanted one that keeps all points in sight; `atDistance` is at least distance().
    double nearestCentre(double wanted, double atDistance) const {
        return glm::clamp(wanted, high_ - slope_ * atDistance, slope_ * atDistance - low_);
    }

private:
    double slope_;
    double high_ = -std::numeric_limits<double>::infinity(), low_ = high_;
};

} // namespace

Camera stageFraming(const Stage& stage, std::span<const dvec3> pointsWorld, const dvec3& lightPositionWorld) {
    Camera camera;
    camera.fovYDegrees = 35.0;                                          // a long lens: little distortion
    const dvec3 backwardWorld = glm::normalize(dvec3(0.35, 0.45, 1.0)); // three-quarter view, 23 degrees down
    const dvec3 rightWorld = glm::normalize(glm::cross(camera.upWorld, backwardWorld));
    const dvec3 aboveWorld = glm::cross(backwardWorld, rightWorld);
    const auto shadowOf = [&](const dvec3& pointWorld) {
        const double t = (lightPositionWorld.y - stage.floorWorld) / (lightPositionWorld.y - pointWorld.y);
        return lightPositionWorld + t * (pointWorld - lightPositionWorld);
    };
    const auto include = [&](AxisFit& across, AxisFit& up, const dvec3& pointWorld) {
        const double backward = glm::dot(pointWorld, backwardWorld);
        across.include(glm::dot(pointWorld, rightWorld), backward);
        up.include(glm::dot(pointWorld, aboveWorld), backward);
    };

    // Slopes as shares of half the picture's height. The mesh is at most 0.6 high. Mesh and shadow stay within 0.8
    // across, which is half of a 16:9 picture less a margin of a tenth. The box about the mesh and its shadow fit a
    // square.
    const double half = std::tan(camera.fovYDegrees * glm::pi<double>() / 360.0);
    AxisFit meshUp(0.6 * half), seenAcross(0.8 * half), seenUp(0.9 * half), boxAcross(0.97 * half), boxUp(0.97 * half);
    for (const dvec3& pointWorld : pointsWorld) {
        meshUp.include(glm::dot(pointWorld, aboveWorld), glm::dot(pointWorld, backwardWorld));
        include(seenAcross, seenUp, pointWorld);
        include(seenAcross, seenUp, shadowOf(pointWorld));
    }
    for (int i = 0; i < 8; ++i) {
        include(boxAcross, boxUp, stage.meshWorld.corner(i));
        include(boxAcross, boxUp, shadowOf(stage.meshWorld.corner(i)));
    }
    double distance = 0.0;
    for (const AxisFit& fit : {meshUp, seenAcross, seenUp, boxAcross, boxUp})
        distance = glm::max(distance, fit.distance());

    // What is seen comes to the middle, as far as the box allows. Distances are measured along `backwardWorld`.
    camera.positionWorld = boxAcross.nearestCentre(seenAcross.centre(), distance) * rightWorld +
                           boxUp.nearestCentre(seenUp.centre(), distance) * aboveWorld + distance * backwardWorld;
    const dvec3 middleWorld = 0.5 * (stage.meshWorld.lowerWorld + stage.meshWorld.upperWorld);
    const double depth = distance - glm::dot(middleWorld, backwardWorld);
    camera.targetWorld = camera.positionWorld - depth * backwardWorld; // beside the mesh: the camera orbits about it
    camera.near = depth / 100.0; // nothing stands that close, and depth precision stays where the mesh is
    return camera;
}

std::vector<Material> stageMaterials() {
    Material floor, clay;
    floor.name = "floor";
    floor.diffuse = vec3(0.75f);
    clay.name = "clay";
    clay.diffuse = vec3(0.72f, 0.62f, 0.52f); // warm, so that the mesh stands out from the grey floor
    return {Material{}, floor, clay};
}

namespace {

/// The vertices that the stage is made for: all but those that lie far from nearly all others.
CommonVertices framedVertices(const std::vector<Object>& pieces) {
    CommonVertices::Pieces meshes;
    for (const Object& piece : pieces)
        meshes.push_back(piece.mesh);
    return CommonVertices(std::move(meshes));
}

std::vector<dvec3> pointsOf(const CommonVertices& vertices, const dmat4& worldFromObject) {
    std::vector<dvec3> pointsWorld;
    vertices.each([&](const dvec3& positionObject, const vec3&) { pointsWorld.push_back(transformPoint(worldFromObject, positionObject)); });
    return pointsWorld;
}

/// The object, or its pieces, without materials, where it came from.
std::vector<Object> piecesOf(ObjFile& obj) {
    std::vector<Object> pieces(1 + obj.furtherPieces.size());
    pieces.front().mesh = sharedMesh(std::move(obj.mesh));
    for (std::size_t i = 1; i < pieces.size(); ++i) {
        pieces[i].mesh = sharedMesh(std::move(obj.furtherPieces[i - 1]));
        pieces[i].isFurtherPiece = true;
    }
    return pieces;
}

/// Beside those of the stage, the materials of the file that parts have.
void addMaterials(Scene& scene, std::vector<Object>& pieces, const std::vector<Material>& fromFile) {
    scene.materials = stageMaterials();
    const MaterialsByName known = materialsByName(fromFile);
    std::map<std::pair<std::string, bool>, std::uint32_t> added; // by the part's name; one material may have two parts in a mesh
    for (Object& piece : pieces)
        for (const MeshPart& part : piece.mesh->parts) {
            piece.partMaterials.push_back(kClay);
            const auto found = known.find(part.materialName);
            if (part.materialName.empty() || found == known.end()) continue;
            const Material& material = fromFile[found->second];
            const auto [entry, isNew] =
                added.try_emplace({part.materialName, part.hasTexcoords}, static_cast<std::uint32_t>(scene.materials.size()));
            piece.partMaterials.back() = entry->second;
            if (!isNew) continue;
            scene.materials.push_back(material);
            scene.materials.back().ofMesh = true;
            for (int i = 0; i < 3; ++i) // parts have different names, so only the three above can be in the way
                if (scene.materials[i].name == material.name) scene.materials.back().name += " (of the mesh)";
        }
}

} // namespace

std::shared_ptr<const Scene> stageObj(const std::filesystem::path& file, const LoadOptions& options) {
    ObjFile obj = loadObj(file, options.normals.value_or(NormalMode::file), options);
    const auto scene = std::make_shared<Scene>();
    scene->name = file.stem().string();
    scene->notes = std::move(obj.notes);

    std::vector<Object> pieces = piecesOf(obj);
    const CommonVertices framed = framedVertices(pieces);
    const Bounds bounds = framed.bounds(dmat4(1.0));
    for (Object& piece : pieces) {
        piece.source.translateWorld = ontoStage(bounds);
        piece.worldFromObject[3] = dvec4(piece.source.translateWorld, 1.0);
    }
    const dmat4& worldFromObject = pieces.front().worldFromObject;
    const Stage stage = stageAround(framed.bounds(worldFromObject), largestExtent(bounds));
    addMaterials(*scene, pieces, obj.materials);
    std::error_code ignored; // it was read a moment ago
    const std::filesystem::path canonical = std::filesystem::weakly_canonical(file, ignored);
    const bool isClay = std::ranges::all_of(pieces, [](const Object& piece) {
        return std::ranges::all_of(piece.partMaterials, [](std::uint32_t material) { return material == kClay; });
    });
    for (Object& piece : pieces) {
        piece.name = scene->name;
        piece.source.mesh = canonical;
        // Where the file has materials of its own, "white" is written as clay for the others (write_scene.h).
        if (isClay) piece.source.material = "clay";
        if (options.normals) piece.source.normals = kNormalModes[static_cast<std::size_t>(*options.normals)];
    }
    Object floor = floorUnder(stage);
    floor.partMaterials = {kFloorMaterial};
    scene->lights = {keyLight(stage)};
    scene->camera = stageFraming(stage, pointsOf(framed, worldFromObject), scene->lights.front().positionWorld);
    scene->ambient = vec3(0.09f);                  // umbra clearly above black
    scene->background = vec3(0.32f, 0.33f, 0.35f); // neutral, darker than the lit floor
    scene->objects.push_back(std::move(floor));
    std::ranges::move(pieces, std::back_inserter(scene->objects));
    addEmitterSurfaces(*scene);
    scene->memory = memoryBudget(*scene, options.limits);
    return scene;
}

} // namespace shadowlab::scene
