// `shadowlab inspect`: what a mesh or a scene is made of, and what that means for each technique.
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <charconv>
#include <span>

#include "app/cli/command.h"
#include "app/cli/common_options.h"
#include "app/cli/inspection.h"
#include "app/cli/json/json_values.h"
#include "app/cli/messages.h"
#include "app/cli/option_values.h"
#include "app/cli/text_table.h"
#include "techniques/foundation/scene/load/message_text.h"
#include "techniques/foundation/scene/model/holes.h"
#include "techniques/foundation/scene/model/surface_color.h"

namespace shadowlab::cli {

namespace {

struct InspectOptions {
    std::string file; ///< a mesh, a .json or the name of a built-in scene
    bool json = false;
    std::optional<scene::NormalMode> normals;   ///< of a mesh; none: as it has them
    std::vector<std::filesystem::path> allowed; ///< further folders a scene may take meshes from
};

void describeInspect(DescribedOptions& add) {
    add.option("FILE", "", "a mesh (.obj, .gltf, .glb), a .json scene or a built-in name (`list scenes`)");
    add.flag("--json", "one JSON object instead of a table");
    describeNormals(add);
    add.option("--allow", "DIR", "a further folder that the scene may take meshes from; may be repeated");
    add.footer("Examples:\n"
               "  shadowlab inspect still-life\n"
               "  shadowlab inspect bunny.obj --json");
}

InspectOptions inspectOptions(const GivenOptions& given) {
    InspectOptions options{given.required("FILE", "for example shadowlab inspect bunny.obj"), given.has("--json"), {}, {}};
    options.allowed = given.allowedFolders();
    options.normals = normalsFrom(given, options.file);
    return options;
}

/// One count of a mesh, as it is called: in JSON, as a line, as a column, and what it is.
struct Count {
    const char *key, *line, *column, *meaning;
    std::uint64_t scene::MeshReport::*value;
};

constexpr std::array kCounts{
    Count{"triangles", "triangles", "triangles", "", &scene::MeshReport::triangles},
    Count{"degenerateTriangles", "  degenerate", "degenerate", "without area, left out when the file was read",
          &scene::MeshReport::droppedTriangles},
    Count{"duplicateTriangles", "  duplicate", "duplicate", "with the same three corners as an earlier one",
          &scene::MeshReport::duplicateTriangles},
    Count{"vertices", "vertices", "vertices", "in the buffers: one for each position, normal and texture coordinate",
          &scene::MeshReport::vertices},
    Count{"weldedVertices", "  welded", "welded", "positions that differ", &scene::MeshReport::weldedVertices},
    Count{"edges", "edges", "edges", "between welded vertices", &scene::MeshReport::edges},
    Count{"boundaryEdges", "  boundary", "boundary", "of one face: the mesh is open there",
          &scene::MeshReport::boundaryEdges},
    Count{"multipleEdges", "  multiple", "multiple", "of more than two faces", &scene::MeshReport::multipleEdges},
    Count{"inconsistentEdges", "  inconsistent", "inconsistent", "of two faces with opposite windings",
          &scene::MeshReport::inconsistentEdges},
    Count{"components", "components", "components", "pieces that hang together by edges",
          &scene::MeshReport::components}};

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
    for (const Count& count : kCounts)
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
    for (const Count& count : kCounts)
        rows[0].push_back(count.column);
    rows[0].insert(rows[0].end(), {"closed", "outward", "holes", "size in m", "step in m"});
    for (const InspectedMesh& mesh : meshes) {
        std::vector<std::string>& row = rows.emplace_back();
        row = {scene::shown(mesh.name, 40), std::to_string(mesh.objects.size())};
        for (const Count& count : kCounts)
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

/// A scene file has one camera beside its views; of a glTF file all are views.
std::size_t camerasOf(const Inspection& inspection) {
    return inspection.scene->views.size() + (inspection.kind == "scene" ? 1 : 0);
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
              {"cameras", std::to_string(camerasOf(inspection))},
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

std::string text(const Inspection& inspection) {
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
        for (const Count& count : kCounts)
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
                 {"cameras", camerasOf(inspection)},
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

int inspect(const InspectOptions& options) {
    const Inspection inspection = inspectFile(options.file, loadOptions(options.allowed, options.normals));
    print(options.json ? inspectionJson(inspection).dump(2, ' ', false, Json::error_handler_t::replace) + "\n"
                       : fitting(text(inspection), terminalColumns()));
    return 0;
}

Work inspectWork(const GivenOptions& given) {
    return [options = inspectOptions(given)] { return inspect(options); };
}

} // namespace

const Command kInspect{"inspect", "FILE", "What a mesh or a scene is made of, and what that means for each technique",
                       describeInspect, inspectWork};

} // namespace shadowlab::cli
