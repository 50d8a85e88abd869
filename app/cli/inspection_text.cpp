// SPDX-License-Identifier: MIT
#include "app/cli/inspection_text.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <span>

#include "app/cli/messages.h"
#include "app/cli/text_table.h"
#include "techniques/foundation/scene/load/message_text.h"
#include "techniques/foundation/scene/model/holes.h"
#include "techniques/foundation/scene/model/surface_color.h"

namespace shadowlab::cli {

namespace {

/// Four digits are enough to read.
std::string metres(double value) {
    std::array<char, 32> buffer{};
    const auto [end, error] =
        std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::general, 4);
    return error == std::errc{} ? std::string(buffer.data(), end) : "?";
}

std::string joined(const dvec3& value, const std::string& between) {
    return metres(value.x) + between + metres(value.y) + between + metres(value.z);
}

/// The first few names, and how many more there are.
std::string named(const std::vector<std::string>& names) {
    constexpr std::size_t kMost = 6;
    std::string text;
    for (std::size_t i = 0; i < std::min(names.size(), kMost); ++i)
        text += (i > 0 ? ", " : "") + scene::shown(names[i], 40);
    return names.size() > kMost ? text + " and " + std::to_string(names.size() - kMost) + " more" : text;
}

std::string yes(bool value) { return value ? "yes" : "no"; }

/// One mesh: a line for each of its numbers.
std::string meshLines(const InspectedMesh& mesh) {
    Rows rows;
    for (const MeshCount& count : kMeshCounts)
        rows.push_back({count.line, std::to_string(mesh.report.*count.value), count.meaning});
    rows.push_back({"closed", yes(mesh.report.isClosed()), "if every edge has two faces, wound alike"});
    rows.push_back({"outward", yes(mesh.outward),
                    "if it is certain that nothing of it is inside out: front faces alone make its shadow volume"});
    rows.push_back({"holes", yes(mesh.report.hasHoles), "if an alpha map cuts holes into it"});
    return aligned(rows, terminalColumns()) + "size: " + joined(mesh.sizeMetres, " x ") + " m\n" +
           "step: " + metres(mesh.stepMetres) + " m between neighbouring floats at most; shortest edges " + metres(mesh.shortestEdge) +
           " m\n";
}

/// Several meshes: a row for each.
std::string meshTable(const std::vector<InspectedMesh>& meshes) {
    Rows rows{{"mesh", "objects"}};
    for (const MeshCount& count : kMeshCounts)
        rows[0].push_back(count.column);
    rows[0].insert(rows[0].end(), {"closed", "outward", "holes", "size in m", "step in m"});
    for (const InspectedMesh& mesh : meshes) {
        std::vector<std::string>& row = rows.emplace_back();
        row = {scene::shown(mesh.name, 40), std::to_string(mesh.objects.size())};
        for (const MeshCount& count : kMeshCounts)
            row.push_back(std::to_string(mesh.report.*count.value));
        row.insert(row.end(), {yes(mesh.report.isClosed()), yes(mesh.outward), yes(mesh.report.hasHoles),
                               joined(mesh.sizeMetres, " x "), metres(mesh.stepMetres)});
    }
    return aligned(rows, terminalColumns());
}

std::string imageText(const std::string& path, ivec2 size, const scene::ImagePlacement& placement) {
    std::string text = std::filesystem::path(path).filename().string() + ", " + std::to_string(size.x) + " x " + std::to_string(size.y);
    if (placement.scale != dvec2(1.0)) text += ", scaled by " + metres(placement.scale.x) + " and " + metres(placement.scale.y);
    if (placement.offset != dvec2(0.0)) text += ", moved by " + metres(placement.offset.x) + " and " + metres(placement.offset.y);
    return text + (placement.clamped ? ", clamped" : "");
}

/// What of a material is seen: its colour, and whatever it has beside.
std::string lookOf(const MaterialLook& look) {
    const scene::Material& material = look.material;
    std::string text = "diffuse " + joined(dvec3(material.diffuse), " ");
    const auto add = [&](bool is, const std::string& what) { text += is ? "; " + what : ""; };
    add(look.vertexColors, "times the colours of the vertices");
    if (material.colorImage) add(true, "times " + imageText(material.diffuseMap, material.colorImage->size(), material.colorPlacement));
    add(material.specular != vec3(0), "highlight " + joined(dvec3(material.specular), " ") + ", exponent " + metres(material.shininess));
    add(material.reflectivity > 0, "mirrors " + metres(material.reflectivity) + " of the light");
    add(material.transparency > 0, "lets " + metres(material.transparency) + " of it pass, index of refraction " + metres(material.ior));
    add(material.emission != vec3(0), "emits " + joined(dvec3(material.emission), " "));
    if (material.alphaMask) add(true, "holes by " + imageText(material.alphaMap, material.alphaMask->size(), material.alphaPlacement));
    return text;
}

std::string materialTable(const std::vector<MaterialLook>& materials) {
    constexpr std::size_t kMost = 30; // a screen of them; --json has all
    Rows rows{{"material", "what is seen of it"}};
    for (std::size_t i = 0; i < std::min(materials.size(), kMost); ++i)
        rows.push_back({scene::shown(materials[i].material.name, 40), lookOf(materials[i])});
    if (materials.size() > kMost) rows.push_back({"...", std::to_string(materials.size() - kMost) + " more"});
    return aligned(rows, terminalColumns());
}

/// "flame (front), panel (both)"
std::string emitterWords(const std::vector<InspectedEmitter>& emitters) {
    std::vector<std::string> words;
    for (const InspectedEmitter& emitter : emitters)
        words.push_back(emitter.material + " (" + std::string(toText(emitter.emits)) + ")");
    return named(words);
}

std::string sceneLines(const Inspection& inspection) {
    const SceneContent& content = *inspection.scene;
    std::string lights;
    for (const auto& [type, count] : content.lights)
        if (count > 0) lights += (lights.empty() ? "" : ", ") + std::to_string(count) + " " + type;
    const auto orNone = [](const std::string& text) { return text.empty() ? "none" : text; };
    Rows rows{{"objects", std::to_string(content.objects)},
              {"triangles", std::to_string(inspection.triangles)},
              {"lights", orNone(lights)},
              {"cameras", std::to_string(content.cameras)},
              {"emitters", orNone(emitterWords(inspection.emitters))},
              {"cast no shadow", orNone(named(content.castNoShadow))},
              {"receive no shadow", orNone(named(content.receiveNoShadow))}};
    if (inspection.kind == "gltf") {
        rows.resize(rows.size() - 2); // it cannot say who casts shadows
        rows.insert(rows.begin(), {"nodes", std::to_string(content.nodes)});
        rows.push_back({"images", std::to_string(content.images)});
    }
    if (!content.views.empty()) rows.push_back({"views", named(content.views)});
    return aligned(rows, terminalColumns());
}

/// Faces at one place: a row for each two surfaces, as many as are read; bodies that stand on something in one line.
std::string coincidingTable(const std::vector<Coinciding>& all) {
    constexpr std::size_t kMost = 12;
    Rows rows{{"coinciding faces", "and", "pairs of triangles", "seen"}};
    std::size_t bodies = 0, left = 0;
    for (const Coinciding& one : all)
        if (one.stands)
            ++bodies;
        else if (rows.size() > kMost)
            ++left;
        else
            rows.push_back({scene::shown(one.first, 40), one.first == one.second ? "itself" : scene::shown(one.second, 40),
                            std::to_string(one.pairs), scene::shown(one.seen, 80)});
    std::string text = rows.size() > 1 ? aligned(rows, terminalColumns()) : "";
    if (left > 0) text += "and " + std::to_string(left) + " more; --json lists all\n";
    if (bodies > 0)
        text += "closed bodies stand on faces of others in " + scene::counted(bodies, "place") + ", which nothing outside sees (--json lists them)\n";
    return text;
}

/// A step is twice the largest error of a rounded position; an origin that holds an edge holds it to 2^-10 (obj/mesh_pieces.h).
constexpr double kCoarse = 0x1p-9;

/// What is odd about where, and how large, a mesh is.
std::string oddities(const InspectedMesh& mesh) {
    const std::string name = scene::shown(mesh.name, 40);
    std::string text;
    if (mesh.scale != Scale::ordinary)
        text += "scale: " + name + " is " + metres(mesh.largestInWorld) + " m across, " +
                (mesh.scale == Scale::tiny ? "smaller than a millimetre" : "larger than ten kilometres") +
                "; was it made in another unit than metres?\n";
    const bool isCoarse = mesh.stepMetres > kCoarse * mesh.shortestEdge;
    std::vector<std::string> places;
    for (const auto& piece : mesh.pieces)
        if (const std::string place = "(" + joined(piece->originObject, ", ") + ")"; std::ranges::find(places, place) == places.end())
            places.push_back(place);
    const std::string origins = named(places);
    if (mesh.pieces.size() > 1)
        text += "origins: " + name + " is too wide for floats about one origin to hold its edges; it is kept in " +
                std::to_string(mesh.pieces.size()) + " pieces, about " + origins + "\n";
    else if (mesh.pieces.front()->originObject != dvec3(0.0))
        text += "origin: " + name + " lies far from its origin; positions are kept relative to " + origins +
                (isCoarse ? "\n" : ", so no detail is lost\n");
    if (isCoarse)
        text += "step: the floats of " + name + " are up to " + metres(mesh.stepMetres) + " m apart, and its shortest edges are " +
                metres(mesh.shortestEdge) + " m long; " +
                (mesh.pieces.size() > 1 ? "it is too scattered for more precision" : "it hangs together and cannot be kept in pieces") +
                ": split it where this matters\n";
    if (const scene::Mesh& first = *mesh.pieces.front(); first.outlierCount > 0) {
        std::string vertices;
        for (const scene::MeshOutlier& outlier : first.outliers)
            vertices += (vertices.empty() ? "" : ", ") + ("v at line " + std::to_string(outlier.line)) + " (number " +
                        std::to_string(outlier.vertex) + ") lies " + metres(outlier.distance) + " m from where most are";
        if (first.outlierCount > first.outliers.size())
            vertices += ", and " + std::to_string(first.outlierCount - first.outliers.size()) + " more";
        text += "outliers: of " + name + ", " + vertices + "; without them it measures " + joined(mesh.sizeWithoutOutliers, " x ") + " m\n";
    }
    return text;
}

} // namespace

std::string inspectionText(const Inspection& inspection) {
    const bool bare = !inspection.scene;
    std::string text = scene::shown(inspection.file, 4096) + (bare ? ": a mesh\n\n" : inspection.kind == "gltf" ? ": a glTF file\n\n" : ": a scene\n\n");
    text += bare ? meshLines(inspection.meshes.front()) : sceneLines(inspection);
    if (!inspection.materials.empty()) text += "\n" + materialTable(inspection.materials);
    if (bare && !inspection.emitters.empty()) text += "emitters: " + emitterWords(inspection.emitters) + "\n";
    if (!bare && !inspection.meshes.empty()) text += "\n" + meshTable(inspection.meshes);
    if (!inspection.coinciding.empty()) text += "\n" + coincidingTable(inspection.coinciding);
    std::string more;
    for (const InspectedMesh& mesh : inspection.meshes)
        more += oddities(mesh);
    for (const std::string& note : inspection.notes)
        more += "note: " + scene::shown(note, 4096) + "\n";
    if (!more.empty()) text += "\n" + more;
    Rows rows;
    for (const Remark& remark : inspection.remarks) {
        std::vector<std::string> names;
        for (const std::size_t mesh : remark.meshes)
            names.push_back(inspection.meshes[mesh].name);
        const bool all = names.size() == inspection.meshes.size();
        rows.push_back({remark.technique, remark.sentence + (all ? "" : " [" + named(names) + "]")});
    }
    if (!rows.empty()) text += "\nWhat that means\n" + aligned(rows, terminalColumns());
    const bool allClosed =
        std::ranges::all_of(inspection.meshes, [](const InspectedMesh& mesh) { return mesh.report.isClosed(); });
    if (!allClosed)
        text += "\nTo see these edges: shadowlab capture " + scene::shown(inspection.file, 4096) +
                " --stage mesh-edges -o edges.png\n";
    return text;
}

} // namespace shadowlab::cli
