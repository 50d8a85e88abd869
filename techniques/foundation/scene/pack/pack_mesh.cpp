// SPDX-License-Identifier: MIT
#include "techniques/foundation/scene/pack/pack_mesh.h"

#include <algorithm>
#include <array>
#include <optional>
#include <sstream>
#include <string_view>

#include "techniques/foundation/scene/load/file_access.h"
#include "techniques/foundation/scene/obj/statement_lines.h"
#include "techniques/foundation/scene/pack/replaced_text.h"

namespace shadowlab::scene {

namespace {

/// Statements of MTL files that name an image, beside all that begin with `map_`.
constexpr std::array<std::string_view, 6> kImageStatements{"bump", "disp", "decal", "refl", "norm", "map"};

bool namesAnImage(std::string_view keyword) {
    return keyword.starts_with("map_") || std::ranges::find(kImageStatements, keyword) != kImageStatements.end();
}

/// Options that may stand before an image's name, and the most values each takes. Fewer are written where the next word is no
/// number.
struct MapOption {
    std::string_view name;
    int values;
    bool numbers;
};
constexpr std::array kMapOptions{
    MapOption{"-o", 3, true},       MapOption{"-s", 3, true},          MapOption{"-t", 3, true},
    MapOption{"-mm", 2, true},      MapOption{"-bm", 1, true},         MapOption{"-boost", 1, true},
    MapOption{"-texres", 1, true},  MapOption{"-clamp", 1, false},     MapOption{"-cc", 1, false},
    MapOption{"-blendu", 1, false}, MapOption{"-blendv", 1, false},    MapOption{"-imfchan", 1, false},
    MapOption{"-type", 1, false},   MapOption{"-colorspace", 1, false}};

constexpr std::string_view kBlanks = " \t";

std::string_view firstWord(std::string_view text) {
    return text.substr(0, std::min(text.find_first_of(kBlanks), text.size()));
}

std::string_view withoutFirstWord(std::string_view text) {
    text.remove_prefix(firstWord(text).size());
    text.remove_prefix(std::min(text.find_first_not_of(kBlanks), text.size()));
    return text;
}

/// The name of the image in what follows the keyword: all behind the options, blanks included.
std::string_view imageName(std::string_view rest) {
    for (;;) {
        const auto option = std::ranges::find(kMapOptions, firstWord(rest), &MapOption::name);
        if (option == kMapOptions.end()) return rest;
        rest = withoutFirstWord(rest);
        for (int i = 0; i < option->values; ++i)
            if (!option->numbers || readNumber(firstWord(rest))) rest = withoutFirstWord(rest);
    }
}

/// One mesh, from the OBJ file on.
class MeshPacker {
public:
    MeshPacker(const std::filesystem::path& file, const LoadOptions& options, PackedFiles& files)
        : file_(file), options_(options), folders_(file, options), files_(files) {}

    std::filesystem::path run() {
        return files_.add(std::filesystem::weakly_canonical(file_), "meshes", file_.filename().string(),
                          [&](const std::filesystem::path& place) {
                              folder_ = place.parent_path();
                              return objText(readFile(file_, options_.limits.fileBytes, "mesh-file"));
                          });
    }

private:
    /// The file that a statement names, if it is there and may be read.
    [[nodiscard]] std::optional<std::filesystem::path> found(std::string_view name) const {
        std::error_code ignored;
        const auto path = folders_.resolve(name);
        return path && std::filesystem::is_regular_file(*path, ignored) ? path : std::nullopt;
    }

    /// Where a copy of the file is, as the mesh beside it has to name it.
    std::string named(const std::filesystem::path& place) const {
        return place.lexically_relative(folder_).generic_string();
    }

    std::string objText(const std::string& text) {
        ReplacedText replaced(text);
        StatementLines lines(text, file_, options_.limits.lineBytes);
        while (lines.nextStatement()) {
            if (lines.keyword() != "mtllib") continue;
            const std::string_view rest = lines.restOfLine();
            if (const auto whole = found(rest)) { // a name may hold blanks, and one line may name several files
                replaced.replace(rest, packedLibrary(*whole, rest));
                continue;
            }
            std::istringstream words{std::string(rest)};
            std::string names;
            for (std::string word; words >> word;) {
                const auto library = found(word);
                names += (names.empty() ? "" : " ") + (library ? packedLibrary(*library, word) : word);
            }
            replaced.replace(rest, names);
        }
        return std::move(replaced).finish();
    }

    /// The last part of a name in a file, which may be written as on Windows.
    static std::string fileName(std::string_view name) {
        return std::string(name.substr(std::min(name.find_last_of("/\\") + 1, name.size())));
    }

    std::string packedLibrary(const std::filesystem::path& canonical, std::string_view name) {
        // The images that it names are found beside the mesh: meshes of one folder share the copy.
        const std::filesystem::path source = canonical.string() + " for " + file_.parent_path().string();
        return named(files_.add(source, folder_, fileName(name), [&](const std::filesystem::path&) {
            return mtlText(readFile(canonical, options_.limits.materialFileBytes, "material-file"), canonical);
        }));
    }

    std::string mtlText(const std::string& text, const std::filesystem::path& library) {
        ReplacedText replaced(text);
        StatementLines lines(text, library, options_.limits.lineBytes);
        while (lines.nextStatement()) {
            if (!namesAnImage(lines.keyword())) continue;
            const std::string_view name = imageName(lines.restOfLine());
            const auto image = found(name);
            if (!image) continue;
            const std::filesystem::path place =
                files_.add(*image, folder_ / "textures", fileName(name), [&](const std::filesystem::path&) {
                    return readFile(*image, options_.limits.imageFileBytes);
                });
            replaced.replace(name, named(place));
        }
        return std::move(replaced).finish();
    }

    const std::filesystem::path& file_;
    const LoadOptions& options_;
    AllowedFolders folders_; ///< all names are relative to the mesh, those in its material files too
    PackedFiles& files_;
    std::filesystem::path folder_; ///< of the mesh in the packed scene
};

} // namespace

std::filesystem::path packMesh(const std::filesystem::path& file, const LoadOptions& options, PackedFiles& files) {
    return MeshPacker(file, options, files).run();
}

} // namespace shadowlab::scene
