// Uses the callback interface of tinyobjloader, compiled here from its packaged header. It passes on each polygon as it is
// in the file; LoadObj would triangulate polygons itself, and count corners in one byte, up to 255. Cutting them into
// triangles is done by polygon_triangulation.h.
// SPDX-License-Identifier: MIT
#include "techniques/foundation/scene/obj/obj_faces.h"

#include <map>
#include <optional>
#include <sstream>
#include <unordered_set>

#include "techniques/foundation/base/error.h"
#include "techniques/foundation/scene/load/file_access.h"
#include "techniques/foundation/scene/load/message_text.h"
#include "techniques/foundation/scene/load/misnamed_files.h"
#include "techniques/foundation/scene/obj/material_libraries.h"
#include "techniques/foundation/scene/obj/material_names.h"

// After material_libraries.h, which includes the header without what it implements.
#define TINYOBJLOADER_IMPLEMENTATION
#include <tiny_obj_loader.h>
#undef TINYOBJLOADER_IMPLEMENTATION

namespace shadowlab::scene {

namespace {

/// Collects what tinyobjloader calls back with.
struct Collector {
    const ObjScan& scan;
    ObjFaces faces;
    std::vector<tinyobj::material_t> materials;
    std::map<std::string, std::uint32_t> materialIndex;
    std::uint32_t currentMaterial = 0;

    std::uint32_t indexOf(const std::string& name) {
        const auto [entry, isNew] =
            materialIndex.try_emplace(name, static_cast<std::uint32_t>(faces.materialNames.size()));
        if (isNew) faces.materialNames.push_back(name);
        return entry->second;
    }

    static void face(void* user, tinyobj::index_t* indices, int count) {
        auto& self = *static_cast<Collector*>(user);
        for (int i = 0; i < count; ++i) {
            // Raw indices count from 1; 0 stands for none. The scan has checked them; they are checked again before they
            // are used as indices.
            const std::int64_t position = indices[i].vertex_index - std::int64_t{1};
            const std::int64_t normal = indices[i].normal_index - std::int64_t{1};
            const std::int64_t texcoord = indices[i].texcoord_index - std::int64_t{1};
            if (position < 0 || position >= std::ssize(self.scan.positions) || normal < -1 ||
                normal >= std::ssize(self.scan.normals) || texcoord < -1 || texcoord >= std::ssize(self.scan.texcoords))
                throw Error(ExitStatus::bug, "an OBJ index changed between check and use; please report this file");
            self.faces.corners.push_back({static_cast<std::uint32_t>(position), static_cast<std::int32_t>(normal),
                                          static_cast<std::int32_t>(texcoord)});
        }
        self.faces.firstCorner.push_back(static_cast<std::uint32_t>(self.faces.corners.size()));
        self.faces.materialOf.push_back(self.currentMaterial);
    }
    static void useMaterial(void* user, const char* name, int) {
        auto& self = *static_cast<Collector*>(user);
        self.currentMaterial = self.indexOf(name);
    }
    static void library(void* user, const tinyobj::material_t* materials, int count) {
        static_cast<Collector*>(user)->materials.assign(materials, materials + count); // all so far, each time
    }
};

/// Gives materials that usemtl names with quotes, a comment or in another case the name that a library defines, and notes it.
/// They are known after that, if not under their own name.
void nameAsDefined(const ObjScan& scan, const std::filesystem::path& file, std::unordered_set<std::string>& known,
                   ObjFaces& faces) {
    std::optional<MaterialNames> names; // only a file with unknown materials needs it
    std::map<std::string, std::string> meant;
    std::string note;
    for (const ObjReference& used : scan.usedMaterials) {
        if (known.contains(used.name)) continue;
        if (!names) names.emplace(known);
        const auto name = names->meant(used.name);
        if (!name) continue;
        meant.emplace(used.name, *name);
        if (meant.size() == 1)
            note = shownPath(file) + ":" + std::to_string(used.line) + ": no material file defines '" +
                   shown(used.name) + "'; " + (name->empty() ? "the default material" : "'" + shown(*name) + "'") +
                   " is taken for it";
    }
    if (meant.empty()) return;
    faces.notes.push_back(note +
                          (meant.size() > 1 ? " (and so for " + counted(meant.size() - 1, "other name") + ")" : ""));
    for (std::string& name : faces.materialNames)
        if (const auto found = meant.find(name); found != meant.end()) name = found->second;
    for (const auto& [used, name] : meant)
        known.insert(used);
}

/// One note for all materials that usemtl names and no library defines.
void noteUnknownMaterials(const ObjScan& scan, const std::filesystem::path& file,
                          const std::unordered_set<std::string>& known, ObjFaces& faces) {
    const ObjReference* first = nullptr;
    std::size_t unknown = 0;
    for (const ObjReference& used : scan.usedMaterials) {
        if (known.contains(used.name)) continue;
        if (unknown++ == 0) first = &used;
    }
    if (!first) return;
    faces.notes.push_back(
        shownPath(file) + ":" + std::to_string(first->line) + ": no material file defines '" + shown(first->name) +
        "'" + (unknown > 1 ? " (and " + counted(unknown - 1, "other") + ")" : "") + "; drawn in the default grey");
}

/// Without an mtllib line, materials are in the file that has the mesh's name, as exporters call it: taken where there is one.
void takeLibraryOfSameName(ObjScan& scan, const std::filesystem::path& file, const LoadOptions& options,
                           std::vector<std::string>& notes) {
    if (!scan.libraries.empty() || scan.usedMaterials.empty()) return;
    const AllowedFolders folders(file, options);
    const auto found = MisnamedFiles(folders).find(file.stem().native() + ".mtl");
    if (!found) return;
    const std::size_t line = scan.usedMaterials.front().line;
    notes.push_back(shownPath(file) + ":" + std::to_string(line) + ": no mtllib names a material file; " +
                    inQuotes(*found) + " beside the mesh is read");
    scan.libraries.push_back({*found, line});
    scan.statements.insert(0, "mtllib 0\n");
}

} // namespace

ObjFaces readFaces(ObjScan& scan, const std::filesystem::path& file, const LoadOptions& options) {
    Collector collector{.scan = scan, .faces = {}, .materials = {}, .materialIndex = {}};
    collector.faces.firstCorner.push_back(0);
    collector.indexOf(""); // faces before the first usemtl
    takeLibraryOfSameName(scan, file, options, collector.faces.notes);
    tinyobj::callback_t callbacks;
    callbacks.index_cb = Collector::face;
    callbacks.usemtl_cb = Collector::useMaterial;
    callbacks.mtllib_cb = Collector::library;

    std::istringstream statements(std::exchange(scan.statements, {}));
    MaterialLibraries libraries(scan, file, options, collector.faces.notes);
    std::string warning, error;
    if (!tinyobj::LoadObjWithCallback(statements, callbacks, &collector, &libraries, &warning, &error))
        throw Error(ExitStatus::badInput, shownPath(file) + ":1: tinyobjloader refuses the file: " + shown(error, 200) +
                                              "; export the mesh again");

    std::unordered_set<std::string> known;
    for (const tinyobj::material_t& mtl : collector.materials) {
        if (mtl.name.empty() || !known.insert(mtl.name).second)
            continue; // LoadMtl adds a nameless one for an empty file
        collector.faces.materials.push_back(libraries.material(mtl));
    }
    libraries.noteWhatWasFound();
    nameAsDefined(scan, file, known, collector.faces);
    noteUnknownMaterials(scan, file, known, collector.faces);
    return std::move(collector.faces);
}

} // namespace shadowlab::scene
