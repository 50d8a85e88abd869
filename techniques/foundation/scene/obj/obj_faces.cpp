// Uses the callback interface of tinyobjloader, compiled here from its packaged header. It passes on each polygon as it is
// in the file; LoadObj would triangulate polygons itself, and count corners in one byte, up to 255. Cutting them into
// triangles is done by polygon_triangulation.h.
// SPDX-License-Identifier: MIT
#include "techniques/foundation/scene/obj/obj_faces.h"

#include <algorithm>
#include <optional>
#include <set>
#include <sstream>
#include <unordered_set>

#define TINYOBJLOADER_IMPLEMENTATION
#define TINYOBJLOADER_USE_DOUBLE
#include <tiny_obj_loader.h>

#include "techniques/foundation/base/error.h"
#include "techniques/foundation/image/output_file.h"
#include "techniques/foundation/scene/load/file_access.h"
#include "techniques/foundation/scene/load/image_files.h"
#include "techniques/foundation/scene/load/message_text.h"
#include "techniques/foundation/scene/load/misnamed_files.h"
#include "techniques/foundation/scene/load/text_encoding.h"
#include "techniques/foundation/scene/obj/library_names.h"
#include "techniques/foundation/scene/obj/material_names.h"
#include "techniques/foundation/scene/obj/mtl_clean.h"

namespace shadowlab::scene {

namespace {

/// Finds, guards, checks and reads material files for tinyobjloader.
class GuardedMaterialReader : public tinyobj::MaterialReader {
public:
    GuardedMaterialReader(const ObjScan& scan, const std::filesystem::path& file, const LoadOptions& options,
                          std::vector<std::string>& notes)
        : scan_(scan), file_(file), options_(options), folders_(file, options), misnamed_(folders_), notes_(notes) {}

    /// `number` is the index into `scan.libraries` that the scan wrote in place of the name.
    bool operator()(const std::string& number, std::vector<tinyobj::material_t>* materials,
                    std::map<std::string, int>* materialIndex, std::string* warning, std::string* error) override {
        const ObjReference& library = scan_.libraries.at(std::stoul(number));
        bool found = false;
        for (const std::string& written : libraryNames(library.name, misnamed_)) {
            const std::string name = asFound(written, library);
            const std::filesystem::path path = allowed(name, library);
            if (!read_.insert(*folders_.resolve(name)).second) continue; // one line may name it ten thousand times
            std::error_code ignored;
            const std::filesystem::file_status status = std::filesystem::status(path, ignored);
            if (!std::filesystem::exists(status)) {
                notes_.push_back(place(library) + ": material file \"" + shown(name) + "\" is missing" +
                                 misnamed_.severalAlike() + "; its materials are drawn in the default grey");
                continue;
            }
            if (std::filesystem::is_directory(status))
                throw Error(ExitStatus::badInput,
                            place(library) + ": material file \"" + shown(name) + "\" is a folder; name a file in it");
            if (const std::string why = whyUnreadable(path); !why.empty())
                throw Error(ExitStatus::badInput, place(library) + ": material file \"" + shown(name) + "\" " + why +
                                                      "; name a readable file");
            const std::string text = utf8Text(readFile(path, options_.limits.materialFileBytes, "material-file"), path);
            image::keepInput(path);
            CleanMtl clean = cleanMtl(text, path, options_.limits, notes_);
            requireMemoryFor(materials_ += clean.names.size(), path);
            std::istringstream statements(std::move(clean.text));
            const std::size_t before = materials->size();
            tinyobj::LoadMtl(materialIndex, materials, &statements, warning, error);
            for (std::size_t i = before; i < materials->size(); ++i)
                if (std::string& numbered = (*materials)[i].name; !numbered.empty()) {
                    numbered = clean.names.at(std::stoul(numbered));
                    folderOf_.try_emplace(numbered, std::filesystem::path(name).parent_path());
                }
            more_.merge(clean.more); // as for the materials, the first library to define one counts
            found = true;
        }
        return found;
    }

    /// What a material's statements say beyond its numbers.
    [[nodiscard]] const MtlStatements& more(const std::string& material) const {
        static const MtlStatements none;
        const auto found = more_.find(material);
        return found == more_.end() ? none : found->second;
    }

    /// The name under which there is such a picture: beside the material's file, else beside the OBJ file, else under another
    /// spelling in either folder. As it is written where there is none.
    [[nodiscard]] std::string pictureAsFound(const MtlMap& map, const std::string& material) {
        const std::string& written = map.file;
        const auto folder = folderOf_.find(material);
        const std::string ofLibrary = folder == folderOf_.end() ? std::string() : folder->second.native();
        if (!ofLibrary.empty() && !std::filesystem::path(written).is_absolute())
            if (std::string beside = ofLibrary + "/" + written; misnamed_.isThere(beside)) return beside;
        if (misnamed_.isThere(written)) return written;
        for (const std::string& inFolder : {ofLibrary, std::string()})
            if (const auto found = misnamed_.find(written, inFolder)) {
                misnamedPictures_.add(map.place, written, *found);
                return *found;
            }
        return written;
    }

    /// On files that were found under another name.
    void noteMisnamed() {
        misnamedLibraries_.appendTo(notes_);
        misnamedPictures_.appendTo(notes_);
    }

private:
    /// The name under which there is such a file; as it is written where there is none.
    [[nodiscard]] std::string asFound(const std::string& written, const ObjReference& library) {
        if (!misnamed_.isThere(written))
            if (const auto found = misnamed_.find(written)) {
                misnamedLibraries_.add(place(library),
                                       library.name.find('#') == std::string::npos ? written : library.name, *found);
                return *found;
            }
        return written;
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
    MisnamedFiles misnamed_;
    MisnamedFilesNote misnamedLibraries_{"material file"}, misnamedPictures_{"picture"};
    std::map<std::string, std::filesystem::path>
        folderOf_;                         ///< of a material: that of its file, relative to the OBJ file's
    std::set<std::filesystem::path> read_; ///< canonical
    std::uint64_t materials_ = 0;          ///< of them all
    std::map<std::string, MtlStatements> more_;
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

/// Reads the images that materials name. One that cannot be read is a note, and the material has none: the mesh is usable without it.
class MtlImages {
public:
    MtlImages(GuardedMaterialReader& reader, const AllowedFolders& folders, const Limits& limits, std::vector<std::string>& notes)
        : reader_(reader), folders_(folders), limits_(limits), notes_(notes) {}

    void read(const MtlStatements& statements, Material& material) {
        if (const auto& map = statements.alphaMap) {
            const MaskChoice choice{map->channel, map->base, map->gain};
            material.alphaPlacement = map->placement;
            make("map_d", *map, material, material.alphaMap,
                 [&](const auto& path) { material.alphaMask = files_.mask(path, choice, limits_); });
        }
        if (const auto& map = statements.diffuseMap) {
            material.colorPlacement = map->placement;
            make("map_Kd", *map, material, material.diffuseMap,
                 [&](const auto& path) { material.colorImage = files_.colors(path, {map->base, map->gain}, limits_); });
        }
    }

private:
    template <typename Make>
    void make(const char* keyword, const MtlMap& map, const Material& material, std::string& path, const Make& makeFrom) {
        const auto ignore = [&](const std::string& why) {
            notes_.push_back(map.place + ": material '" + shown(material.name) + "': " + keyword + " \"" + shown(map.file) +
                             "\" is ignored: " + why);
        };
        const auto resolved = folders_.resolve(reader_.pictureAsFound(map, material.name));
        if (!resolved) return ignore("it " + std::string(kOutsideMessage));
        if (const std::string fault = whyUnreadable(*resolved); !fault.empty()) return ignore("it " + fault);
        try {
            makeFrom(*resolved);
            path = resolved->string();
        } catch (const Error& error) {
            ignore(error.what());
        }
    }

    GuardedMaterialReader& reader_;
    const AllowedFolders& folders_;
    const Limits& limits_;
    std::vector<std::string>& notes_;
    ImageFiles files_;
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
    GuardedMaterialReader materialReader(scan, file, options, collector.faces.notes);
    std::string warning, error;
    if (!tinyobj::LoadObjWithCallback(statements, callbacks, &collector, &materialReader, &warning, &error))
        throw Error(ExitStatus::badInput, shownPath(file) + ":1: tinyobjloader refuses the file: " + shown(error, 200) +
                                              "; export the mesh again");

    const AllowedFolders folders(file, options);
    MtlImages images(materialReader, folders, options.limits, collector.faces.notes);
    std::unordered_set<std::string> known;
    for (const tinyobj::material_t& mtl : collector.materials) {
        if (mtl.name.empty() || !known.insert(mtl.name).second)
            continue; // LoadMtl adds a nameless one for an empty file
        const MtlStatements& more = materialReader.more(mtl.name);
        Material& material = collector.faces.materials.emplace_back(converted(mtl));
        images.read(more, material);
        // An image alone is the colour; beside a Kd it is multiplied with it. Black would hide it, and is what some programs write.
        if (material.colorImage && (!more.hasDiffuse || material.diffuse == vec3(0))) material.diffuse = vec3(1.0f);
        applyOptics(more, material);
    }
    materialReader.noteMisnamed();
    nameAsDefined(scan, file, known, collector.faces);
    noteUnknownMaterials(scan, file, known, collector.faces);
    return std::move(collector.faces);
}

} // namespace shadowlab::scene
