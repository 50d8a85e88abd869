// SPDX-License-Identifier: MIT
#include "techniques/foundation/scene/pack/pack_mesh.h"

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "techniques/foundation/scene/load/file_access.h"
#include "techniques/foundation/scene/load/misnamed_files.h"
#include "techniques/foundation/scene/load/scene_file.h"
#include "techniques/foundation/scene/load/text_encoding.h"
#include "techniques/foundation/scene/obj/library_names.h"
#include "techniques/foundation/scene/obj/mtl_map.h"
#include "techniques/foundation/scene/obj/statement_lines.h"
#include "techniques/foundation/scene/pack/pack_gltf.h"
#include "techniques/foundation/scene/pack/replaced_text.h"

namespace shadowlab::scene {

namespace {

/// Statements of MTL files that name an image, beside all that begin with `map_`.
constexpr std::array<std::string_view, 6> kImageStatements{"bump", "disp", "decal", "refl", "norm", "map"};

bool namesAnImage(std::string_view keyword) {
    return keyword.starts_with("map_") || std::ranges::find(kImageStatements, keyword) != kImageStatements.end();
}

/// One mesh, from the OBJ file on.
class MeshPacker {
public:
    MeshPacker(const std::filesystem::path& file, const LoadOptions& options, PackedFiles& files)
        : file_(file), options_(options), folders_(file, options), misnamed_(folders_), files_(files) {}

    std::filesystem::path run() {
        return files_.add(std::filesystem::weakly_canonical(file_), "meshes", file_.filename().string(),
                          [&](const std::filesystem::path& place) {
                              folder_ = place.parent_path();
                              return objText(utf8Text(readFile(file_, options_.limits.fileBytes, "mesh-file"), file_));
                          });
    }

private:
    struct Found {
        std::filesystem::path canonical;
        std::string name; ///< in its folder: that of the link where it is one, and without what a statement adds, such as quotes
    };

    /// The file that a statement names, under whatever spelling, if it is there and may be read. `inFolder` is the folder of the
    /// statement's file, relative to the mesh's; it comes first.
    [[nodiscard]] std::optional<Found> found(const std::string& name, const std::string& inFolder = {}) {
        const auto file = [&](const std::string& reference) -> std::optional<Found> {
            std::error_code ignored;
            const auto path = folders_.resolve(reference);
            if (!path || !std::filesystem::is_regular_file(*path, ignored)) return std::nullopt;
            return Found{*path, std::filesystem::path(reference).filename().string()};
        };
        if (!inFolder.empty() && !std::filesystem::path(name).is_absolute())
            if (auto beside = file(inFolder + "/" + name)) return beside;
        if (auto plain = file(name)) return plain;
        for (const std::string& folder : {inFolder, std::string()})
            if (const auto respelt = misnamed_.find(name, folder))
                if (auto other = file(*respelt)) return other;
        return std::nullopt;
    }

    /// Where a copy of the file is, as the mesh beside it has to name it.
    std::string named(const std::filesystem::path& place) const {
        return place.lexically_relative(folder_).generic_string();
    }

    std::string objText(const std::string& text) {
        ReplacedText replaced(text);
        StatementLines lines(text, file_, options_.limits.lineBytes);
        bool namesLibrary = false;
        while (lines.nextStatement()) {
            if (lines.keyword() != "mtllib") continue;
            namesLibrary = true;
            const std::string_view rest = lines.restOfLine();
            const std::vector<std::string> names = libraryNames(std::string(rest), misnamed_);
            std::string packed;
            for (const std::string& name : names) {
                const auto library = found(name);
                const std::string place = library ? packedLibrary(*library) : name;
                const bool isQuoted = names.size() > 1 && place.find(' ') != std::string::npos;
                packed += (packed.empty() ? "" : " ") + (isQuoted ? '"' + place + '"' : place);
            }
            if (!packed.empty()) replaced.replace(rest, packed);
        }
        const std::string ofSameName = file_.stem().string() + ".mtl"; // what is read where no library is named
        if (const auto library = namesLibrary ? std::nullopt : found(ofSameName)) packedLibrary(*library);
        return std::move(replaced).finish();
    }

    std::string packedLibrary(const Found& library) {
        const std::filesystem::path& canonical = library.canonical;
        // The images that it names are found beside the mesh: meshes of one folder share the copy.
        const std::filesystem::path source = canonical.string() + " for " + file_.parent_path().string();
        return named(files_.add(source, folder_, library.name, [&](const std::filesystem::path&) {
            return mtlText(utf8Text(readFile(canonical, options_.limits.materialFileBytes, "material-file"), canonical), canonical);
        }));
    }

    std::string mtlText(const std::string& text, const std::filesystem::path& library) {
        ReplacedText replaced(text);
        StatementLines lines(text, library, options_.limits.lineBytes);
        const std::string inFolder =
            library.parent_path().lexically_relative(std::filesystem::weakly_canonical(file_).parent_path()).generic_string();
        while (lines.nextStatement()) {
            if (!namesAnImage(lines.keyword())) continue;
            const std::string_view rest = lines.restOfStatement();
            std::string statement = onOneLine(rest);
            const MtlMap map = parseMtlMap(statement);
            const auto image = map.file.empty() ? std::nullopt : found(map.file, inFolder);
            if (!image) continue;
            const std::filesystem::path place =
                files_.add(image->canonical, folder_ / "textures", image->name, [&](const std::filesystem::path&) {
                    return readFile(image->canonical, options_.limits.imageFileBytes);
                });
            replaced.replace(rest, statement.replace(map.fileAt, map.file.size(), named(place)));
        }
        return std::move(replaced).finish();
    }

    const std::filesystem::path& file_;
    const LoadOptions& options_;
    AllowedFolders folders_; ///< names are relative to the mesh; those in a material file first to that
    MisnamedFiles misnamed_;
    PackedFiles& files_;
    std::filesystem::path folder_; ///< of the mesh in the packed scene
};

} // namespace

std::filesystem::path packMesh(const std::filesystem::path& file, const LoadOptions& options, PackedFiles& files) {
    if (fileKind(file) == FileKind::gltf) return packGltf(file, options, files);
    return MeshPacker(file, options, files).run();
}

} // namespace shadowlab::scene
