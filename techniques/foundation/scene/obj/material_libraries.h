// The material files of one OBJ file: found, guarded, checked and read for tinyobjloader, and what becomes of their materials.
// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

#ifndef TINYOBJLOADER_USE_DOUBLE
#define TINYOBJLOADER_USE_DOUBLE
#endif
#include <tiny_obj_loader.h>

#include "techniques/foundation/scene/load/file_access.h"
#include "techniques/foundation/scene/load/image_files.h"
#include "techniques/foundation/scene/load/misnamed_files.h"
#include "techniques/foundation/scene/model/scene.h"
#include "techniques/foundation/scene/obj/mtl_optics.h"
#include "techniques/foundation/scene/obj/obj_scan.h"

namespace shadowlab::scene {

class MaterialLibraries : public tinyobj::MaterialReader {
public:
    /// All of these must outlive this object.
    MaterialLibraries(const ObjScan& scan, const std::filesystem::path& file, const LoadOptions& options,
                      std::vector<std::string>& notes);

    /// `number` is the index into `scan.libraries` that the scan wrote in place of the name. Throws Error for a file that cannot be read.
    bool operator()(const std::string& number, std::vector<tinyobj::material_t>* materials,
                    std::map<std::string, int>* materialIndex, std::string* warning, std::string* error) override;

    /// A material as tinyobjloader passes it on, with all that its file says, and its images. An image that cannot be read is a note,
    /// and the material has none: the mesh is usable without it.
    [[nodiscard]] Material material(const tinyobj::material_t& mtl);

    /// Notes on files that were found under another name, and on images that are not drawn whole.
    void noteWhatWasFound();

private:
    [[nodiscard]] std::string asFound(const std::string& written, const ObjReference& library);
    [[nodiscard]] std::string pictureAsFound(const MtlMap& map, const std::string& material);
    [[nodiscard]] std::filesystem::path allowed(const std::string& name, const ObjReference& library) const;
    void requireReadable(const std::filesystem::path& path, const std::string& name, const ObjReference& library) const;
    void requireMemoryFor(std::uint64_t materials, const std::filesystem::path& path) const;
    [[nodiscard]] std::string place(const ObjReference& library) const;
    void readImages(const MtlStatements& statements, Material& material);
    template <typename Make>
    void readImage(const char* keyword, const MtlMap& map, const Material& material, std::string& path, const Make& make);

    const ObjScan& scan_;
    const std::filesystem::path& file_;
    const LoadOptions& options_;
    AllowedFolders folders_;
    MisnamedFiles misnamed_;
    MisnamedFilesNote misnamedLibraries_{"material file"}, misnamedPictures_{"picture"};
    std::map<std::string, std::filesystem::path> folderOf_; ///< of a material: that of its file, relative to the OBJ file's
    std::set<std::filesystem::path> read_;                  ///< canonical
    std::uint64_t materials_ = 0;                           ///< of them all
    std::map<std::string, MtlStatements> more_;             ///< of each material; the first library to define one counts
    ImageFiles images_;
    std::size_t drawnOpaque_ = 0; ///< images with transparent parts that are drawn opaque
    std::string firstDrawnOpaque_;
    std::vector<std::string>& notes_;
};

} // namespace shadowlab::scene
