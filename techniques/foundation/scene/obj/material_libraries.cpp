// SPDX-License-Identifier: MIT
#include "techniques/foundation/scene/obj/material_libraries.h"

#include <algorithm>
#include <sstream>

#include "techniques/foundation/base/error.h"
#include "techniques/foundation/image/output_file.h"
#include "techniques/foundation/scene/load/message_text.h"
#include "techniques/foundation/scene/load/text_encoding.h"
#include "techniques/foundation/scene/obj/library_names.h"
#include "techniques/foundation/scene/obj/mtl_clean.h"

namespace shadowlab::scene {

namespace {

vec3 color(const tinyobj::real_t (&rgb)[3]) { return {dvec3(rgb[0], rgb[1], rgb[2])}; }

/// The numbers alone.
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

} // namespace

MaterialLibraries::MaterialLibraries(const ObjScan& scan, const std::filesystem::path& file, const LoadOptions& options,
                                     std::vector<std::string>& notes)
    : scan_(scan), file_(file), options_(options), folders_(file, options), misnamed_(folders_), notes_(notes) {}

bool MaterialLibraries::operator()(const std::string& number, std::vector<tinyobj::material_t>* materials,
                                   std::map<std::string, int>* materialIndex, std::string* warning, std::string* error) {
    const ObjReference& library = scan_.libraries.at(std::stoul(number));
    bool found = false;
    for (const std::string& written : libraryNames(library.name, misnamed_)) {
        const std::string name = asFound(written, library);
        const std::filesystem::path path = allowed(name, library);
        if (!read_.insert(*folders_.resolve(name)).second) continue; // one line may name it ten thousand times
        if (std::error_code ignored; !std::filesystem::exists(std::filesystem::status(path, ignored))) {
            notes_.push_back(place(library) + ": material file \"" + shown(name) + "\" is missing" + misnamed_.severalAlike() +
                             "; its materials are drawn in the default grey");
            continue;
        }
        requireReadable(path, name, library);
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
        more_.merge(clean.more);
        found = true;
    }
    return found;
}

void MaterialLibraries::requireReadable(const std::filesystem::path& path, const std::string& name,
                                        const ObjReference& library) const {
    const auto refuse = [&](const std::string& why) {
        throw Error(ExitStatus::badInput, place(library) + ": material file \"" + shown(name) + "\" " + why);
    };
    if (std::error_code ignored; std::filesystem::is_directory(path, ignored)) refuse("is a folder; name a file in it");
    if (const std::string why = whyUnreadable(path); !why.empty()) refuse(why + "; name a readable file");
}

/// The name under which there is such a file; as it is written where there is none.
std::string MaterialLibraries::asFound(const std::string& written, const ObjReference& library) {
    if (misnamed_.isThere(written)) return written;
    const auto found = misnamed_.find(written);
    if (!found) return written;
    misnamedLibraries_.add(place(library), library.name.find('#') == std::string::npos ? written : library.name, *found);
    return *found;
}

/// The file as the OBJ file's path and the name in it give it, to open and to name in messages.
std::filesystem::path MaterialLibraries::allowed(const std::string& name, const ObjReference& library) const {
    if (folders_.resolve(name)) return file_.parent_path() / name;
    throw Error(ExitStatus::badInput,
                place(library) + ": material file \"" + shown(name) + "\" " + std::string(kOutsideMessage));
}

void MaterialLibraries::requireMemoryFor(std::uint64_t materials, const std::filesystem::path& path) const {
    const Limits& limits = options_.limits;
    if (const std::uint64_t needed = memoryForMaterials(materials, limits); needed > limits.memoryBytes)
        throw Error(ExitStatus::overLimit, shownPath(path) + ": for " + counted(materials, "material") + ", " +
                                               beyondMemory(needed, limits.memoryBytes) +
                                               "; leave out those that no face uses, or set --limit memory=VALUE");
}

std::string MaterialLibraries::place(const ObjReference& library) const {
    return shownPath(file_) + ":" + std::to_string(library.line);
}

Material MaterialLibraries::material(const tinyobj::material_t& mtl) {
    Material material = converted(mtl);
    const auto found = more_.find(mtl.name);
    if (found == more_.end()) return material;
    const MtlStatements& more = found->second;
    readImages(more, material);
    // An image alone is the colour; beside a Kd it is multiplied with it. Black would hide it, and is what some programs write.
    if (material.colorImage && (!more.hasDiffuse || material.diffuse == vec3(0))) material.diffuse = vec3(1.0f);
    applyOptics(more, material);
    return material;
}

void MaterialLibraries::readImages(const MtlStatements& statements, Material& material) {
    const Limits& limits = options_.limits;
    if (const auto& map = statements.alphaMap) {
        const MaskChoice choice{map->channel, map->base, map->gain};
        material.alphaPlacement = map->placement;
        readImage("map_d", *map, material, material.alphaMap,
                  [&](const auto& path) { material.alphaMask = images_.mask(path, choice, limits); });
    }
    if (const auto& map = statements.diffuseMap) {
        material.colorPlacement = map->placement;
        readImage("map_Kd", *map, material, material.diffuseMap,
                  [&](const auto& path) { material.colorImage = images_.colors(path, {map->base, map->gain}, limits); });
        if (material.colorImage && material.colorImage->isPartlyTransparent() && !material.alphaMask && drawnOpaque_++ == 0)
            firstDrawnOpaque_ = map->place + ": material '" + shown(material.name) + "': map_Kd \"" + shown(map->file) +
                                "\" has transparent parts, which are drawn opaque; to cut them out, name the image with map_d as well";
    }
}

template <typename Make>
void MaterialLibraries::readImage(const char* keyword, const MtlMap& map, const Material& material, std::string& path,
                                  const Make& make) {
    const auto ignore = [&](const std::string& why) {
        notes_.push_back(map.place + ": material '" + shown(material.name) + "': " + keyword + " \"" + shown(map.file) +
                         "\" is ignored: " + why);
    };
    const auto resolved = folders_.resolve(pictureAsFound(map, material.name));
    if (!resolved) return ignore("it " + std::string(kOutsideMessage));
    if (const std::string fault = whyUnreadable(*resolved); !fault.empty()) return ignore("it " + fault);
    try {
        make(*resolved);
        path = resolved->string();
    } catch (const Error& error) {
        ignore(error.what());
    }
}

/// The name under which there is such a picture: beside the material's file, else beside the OBJ file, else under another
/// spelling in either folder. As it is written where there is none.
std::string MaterialLibraries::pictureAsFound(const MtlMap& map, const std::string& material) {
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

void MaterialLibraries::noteWhatWasFound() {
    if (drawnOpaque_ > 0)
        notes_.push_back(firstDrawnOpaque_ + (drawnOpaque_ > 1 ? " (and " + counted(drawnOpaque_ - 1, "more material") + ")" : ""));
    misnamedLibraries_.appendTo(notes_);
    misnamedPictures_.appendTo(notes_);
}

} // namespace shadowlab::scene
