// SPDX-License-Identifier: MIT
#include "app/cli/inspection_json.h"

#include <array>

namespace shadowlab::cli {

Json inspectionJson(const Inspection& inspection) {
    Json meshes = Json::array(), remarks = Json::array(), materials = Json::array(), looks = Json::array(), emitters = Json::array(), coinciding = Json::array(), scene;
    for (const auto& [material, vertexColors] : inspection.materials) {
        materials.push_back(material.name);
        looks.push_back({{"name", material.name},
                         {"diffuse", vectorJson(dvec3(material.diffuse))},
                         {"specular", vectorJson(dvec3(material.specular))},
                         {"emission", vectorJson(dvec3(material.emission))},
                         {"reflectivity", material.reflectivity},
                         {"transparency", material.transparency},
                         {"diffuseMap", material.diffuseMap},
                         {"alphaMap", material.alphaMap},
                         {"vertexColors", vertexColors}});
    }
    for (const InspectedEmitter& emitter : inspection.emitters)
        emitters.push_back({{"material", emitter.material}, {"emits", toText(emitter.emits)}});
    for (const InspectedMesh& mesh : inspection.meshes) {
        Json& entry = meshes.emplace_back(Json{{"name", mesh.name}, {"objects", mesh.objects}});
        for (const MeshCount& count : kMeshCounts)
            entry[count.key] = mesh.report.*count.value;
        constexpr std::array kScales{"ordinary", "tiny", "huge"};
        entry["closed"] = mesh.report.isClosed();
        entry["outward"] = mesh.outward;
        entry["holes"] = mesh.report.hasHoles;
        entry["sizeMetres"] = vectorJson(mesh.sizeMetres);
        entry["sizeWithoutOutliers"] = vectorJson(mesh.sizeWithoutOutliers);
        entry["originOffset"] = vectorJson(mesh.pieces.front()->originObject);
        entry["origins"] = Json::array(); // of its pieces
        for (const auto& piece : mesh.pieces)
            entry["origins"].push_back(vectorJson(piece->originObject));
        entry["stepMetres"] = mesh.stepMetres;
        entry["shortestEdge"] = mesh.shortestEdge;
        entry["outlierCount"] = mesh.pieces.front()->outlierCount;
        entry["outliers"] = Json::array(); // the first few
        for (const scene::MeshOutlier& outlier : mesh.pieces.front()->outliers)
            entry["outliers"].push_back({{"vertex", outlier.vertex}, {"line", outlier.line}, {"distance", outlier.distance}});
        entry["largestInWorld"] = mesh.largestInWorld;
        entry["scale"] = kScales[static_cast<std::size_t>(mesh.scale)];
    }
    for (const Coinciding& one : inspection.coinciding)
        coinciding.push_back({{"first", one.first}, {"second", one.second}, {"faceAlike", one.faceAlike}, {"stands", one.stands}, {"pairs", one.pairs}, {"seen", one.seen}});
    for (const Remark& remark : inspection.remarks)
        for (const std::size_t mesh : remark.meshes)
            remarks.push_back(
                {{"technique", remark.technique}, {"mesh", inspection.meshes[mesh].name}, {"remark", remark.sentence}});
    if (inspection.scene) {
        scene = {{"objects", inspection.scene->objects},
                 {"lights", inspection.scene->lights},
                 {"cameras", inspection.scene->cameras},
                 {"views", inspection.scene->views},
                 {"castNoShadow", inspection.scene->castNoShadow},
                 {"receiveNoShadow", inspection.scene->receiveNoShadow}};
        if (inspection.kind == "gltf") scene.update({{"nodes", inspection.scene->nodes}, {"images", inspection.scene->images}});
    }
    return {{"file", inspection.file},
            {"kind", inspection.kind},
            {"name", inspection.name},
            {"triangles", inspection.triangles},
            {"materials", materials},
            {"materialLooks", looks},
            {"emitters", emitters},
            {"scene", scene},
            {"meshes", meshes},
            {"coinciding", coinciding},
            {"remarks", remarks},
            {"notes", inspection.notes}};
}

} // namespace shadowlab::cli
