// Uses the callback interface of tinyobjloader, compiled here from its packaged header. It passes on each polygon as it is
// in the file; LoadObj would triangulate polygons itself, and count corners in one byte, up to 255. Cutting them into
// triangles is done by polygon_triangulation.h.
// SPDX-License-Identifier: MIT
#include "techniques/foundation/scene/obj/obj_faces.h"

#include <algorithm>
#include <set>
#include <sstream>
#include <unordered_set>

#define TINYOBJLOADER_IMPLEMENTATION
#define TINYOBJLOADER_USE_DOUBLE
#include <tiny_obj_loader.h>

#include "techniques/foundation/base/error.h"
#include "techniques/foundation/image/output_file.h"
#include "techniques/foundation/scene/load/file_access.h"
#include "techniques/foundation/scene/load/message_text.h"
#include "techniques/foundation/scene/model/holes.h"
#include "techniques/foundation/scene/obj/mtl_clean.h"

namespace shadowlab::scene {

namespace {

/// Finds, guards, checks and reads material files for tinyobjloader.
class GuardedMaterialReader : public tinyobj::MaterialReader {
public:
    GuardedMaterialReader(const ObjScan& scan, const std::filesystem::path& file, const LoadOptions& options,
                          std::vector<std::string>& notes)
        : scan_(scan), file_(file), options_(options), folders_(file, options), notes_(notes) {}

    /// `number` is the index into `scan.libraries` that the scan wrote in place of the name.
    bool operator()(const std::string& number, std::vector<tinyobj::material_t>* materials,
                    std::map<std::string, int>* materialIndex, std::string* warning, std::string* error) override {
        const ObjReference& library = scan_.libraries.at(std::stoul(number));
        bool found = false;
        for (const std::string& name : candidates(library)) {
            const std::filesystem::path path = allowed(name, library);
            if (!read_.insert(*folders_.resolve(name)).second) continue; // one line may name it ten thousand times
            std::error_code ignored;
            const std::filesystem::file_status status = std::filesystem::status(path, ignored);
            if (!std::filesystem::exists(status)) {
                notes_.push_back(place(library) + ": material file \"" + shown(name) +
                                 "\" is missing; its materials are drawn in the default grey");
                continue;
            }
            if (std::filesystem::is_directory(status))
                throw Error(ExitStatus::badInput,
                            place(library) + ": material file \"" + shown(name) + "\" is a folder; name a file in it");
            if (const std::string why = whyUnreadable(path); !why.empty())
                throw Error(ExitStatus::badInput, place(library) + ": material file \"" + shown(name) + "\" " + why +
                                                      "; name a readable file");
            const std::string text = readFile(path, options_.limits.materialFileBytes, "material-file");
            image::keepInput(path);
            CleanMtl clean = cleanMtl(text, path, options_.limits, notes_);
            requireMemoryFor(materials_ += clean.names.size(), path);
            std::istringstream statements(std::move(clean.text));
            const std::size_t before = materials->size();
            tinyobj::LoadMtl(materialIndex, materials, &statements, warning, error);
            for (std::size_t i = before; i < materials->size(); ++i)
                if (std::string& numbered = (*materials)[i].name; !numbered.empty())
                    numbered = clean.names.at(std::stoul(numbered));
            alphaMapPlaces_.merge(clean.alphaMapPlaces); // as for the materials, the first library to define one counts
            found = true;
        }
        return found;
    }

    /// "FILE:LINE: " of a material's map_d.
    [[nodiscard]] std::string alphaMapPlace(const std::string& material) const {
        const auto found = alphaMapPlaces_.find(material);
        return found == alphaMapPlaces_.end() ? "" : found->second + ": ";
    }

private:
    /// A library name may hold blanks, and one line may name several files: the whole line is tried first.
    [[nodiscard]] std::vector<std::string> candidates(const ObjReference& library) const {
        std::vector<std::string> names;
        std::istringstream words(library.name);
        for (std::string word; words >> word;)
            names.push_back(word);
        std::error_code ignored;
        if (names.size() > 1)
            if (const auto whole = folders_.resolve(library.name); whole && std::filesystem::exists(*whole, ignored))
                names.assign(1, library.name);
        return names;
    }

    /// The file as the OBJ file's path and the name in it give it, to open and to name in messages.
    [[nodiscard]] std::filesystem::path allowed(const std::string& name, const ObjReference& library) const {
        if (folders_.resolve(name)) return file_.parent_path() / name;
        throw Error(ExitStatus::badInput,
                    place(library) + ": material file \"" + shown(name) + "\" " + std::string(kOutsideMessage));
    }

    void requireMemoryFor(std::uint64_t materials, const std::filesystem::path& path) const {
        const Limits& limits = options_.limits;
        if (const std::uint64_t needed = memoryForMaterials(materials, limits); needed > limits.memoryBytes)
            throw Error(ExitStatus::overLimit, shownPath(path) + ": for " + counted(materials, "material") + ", " +
                                                   beyondMemory(needed, limits.memoryBytes) +
                                                   "; leave out those that no face uses, or set --limit memory=VALUE");
    }

    [[nodiscard]] std::string place(const ObjReference& library) const {
        return shownPath(file_) + ":" + std::to_string(library.line);
    }

    const ObjScan& scan_;
    const std::filesystem::path& file_;
    const LoadOptions& options_;
    AllowedFolders folders_;
    std::set<std::filesystem::path> read_; ///< canonical
    std::uint64_t materials_ = 0;          ///< of them all
    std::map<std::string, std::string> alphaMapPlaces_;
    std::vector<std::string>& notes_;
};

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

vec3 color(const tinyobj::real_t (&rgb)[3]) { return {dvec3(rgb[0], rgb[1], rgb[2])}; }

Material converted(const tinyobj::material_t& mtl) {
    Material material;
    material.name = mtl.name;
    material.diffuse = color(mtl.diffuse);
    material.specular = color(mtl.specular);
    material.shininess = static_cast<float>(mtl.shininess);
    material.emission = color(mtl.emission);
    // Programs wind the faces of a room either way, and an MTL file cannot say which side shines (docs/scene_format.md).
    material.emits = EmittingSides::both;
    material.transparency = std::clamp(1.0 - mtl.dissolve, 0.0, 1.0);
    material.ior = mtl.ior;
    return material;
}

/// map_d: kept if it can be read. Otherwise a note is made and the material has no mask, because the mesh is usable without
/// it.
void readMtlAlphaMap(const tinyobj::material_t& mtl, const std::string& place, Material& material,
                     const AllowedFolders& folders, AlphaMasks& masks, const Limits& limits,
                     std::vector<std::string>& notes) {
    if (mtl.alpha_texname.empty()) return;
    const auto ignore = [&](const std::string& why) {
        notes.push_back(place + "material '" + shown(mtl.name) + "': map_d \"" + shown(mtl.alpha_texname) + "\" " +
                        why);
    };
    const auto path = folders.resolve(mtl.alpha_texname);
    if (!path) return ignore("is ignored: it " + std::string(kOutsideMessage));
    if (const std::string fault = whyUnreadable(*path); !fault.empty()) return ignore("is ignored: it " + fault);
    try {
        material.alphaMask = masks.load(*path, limits);
        material.alphaMap = path->string();
    } catch (const Error& error) {
        ignore("is ignored: " + std::string(error.what()));
    }
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

} // namespace

ObjFaces readFaces(ObjScan& scan, const std::filesystem::path& file, const LoadOptions& options) {
    Collector collector{.scan = scan, .faces = {}, .materials = {}, .materialIndex = {}};
    collector.faces.firstCorner.push_back(0);
    collector.indexOf(""); // faces before the first usemtl
    tinyobj::callback_t callbacks;
    callbacks.index_cb = Collector::face;
    callbacks.usemtl_cb = Collector::useMaterial;
    callbacks.mtllib_cb = Collector::library;

    std::istringstream statements(std::exchange(scan.statements, {}));
    GuardedMaterialReader materialReader(scan, file, options, collector.faces.notes);
    std::string warning, error;
    if (!tinyobj::LoadObjWithCallback(statements, callbacks, &collector, &materialReader, &warning, &error))
        throw Error(ExitStatus::badInput, shownPath(file) + ":1: tinyobjloader refuses the file: " + shown(error, 200) +
                                              "; export the mesh again");

    const AllowedFolders folders(file, options);
    AlphaMasks masks;
    std::unordered_set<std::string> known;
    for (const tinyobj::material_t& mtl : collector.materials) {
        if (mtl.name.empty() || !known.insert(mtl.name).second)
            continue; // LoadMtl adds a nameless one for an empty file
        collector.faces.materials.push_back(converted(mtl));
        readMtlAlphaMap(mtl, materialReader.alphaMapPlace(mtl.name), collector.faces.materials.back(), folders, masks,
                        options.limits, collector.faces.notes);
    }
    noteUnknownMaterials(scan, file, known, collector.faces);
    return std::move(collector.faces);
}

} // namespace shadowlab::scene
