// The bytes that a glTF file names: those of its buffers, and of any of its images.
// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "techniques/foundation/scene/gltf/gltf_check.h"
#include "techniques/foundation/scene/load/load.h"
#include "techniques/foundation/scene/load/misnamed_files.h"

namespace shadowlab::scene {

struct GltfContainer;

/// Files beside the glTF file, found as those of an OBJ file are: only in allowed folders, also under a name that is written
/// otherwise. Nothing is looked up before a URI names a file.
class GltfFiles {
public:
    GltfFiles(const std::filesystem::path& file, const LoadOptions& options) : file_(file), options_(options) {}

    struct Found {
        std::optional<std::filesystem::path> canonical;
        std::string fault{}; ///< "cannot be read: No such file or directory", say; empty: none
    };
    /// The file that a string of the document, a URI and no data: URI, names. A name that is written otherwise is noted.
    Found find(const JsonDocument& document, const JsonValue& uri);

    void appendNotesTo(std::vector<std::string>& notes) const { misnamedNote_.appendTo(notes); }

private:
    const std::filesystem::path& file_;
    const LoadOptions& options_;
    std::optional<AllowedFolders> folders_;
    std::optional<MisnamedFiles> misnamed_;
    MisnamedFilesNote misnamedNote_{"the file"};
};

/// The buffers of a checked file. Each holds as many bytes as it says.
class GltfBuffers {
public:
    /// Throws Error (badInput, overLimit) at the buffer whose bytes are not there.
    GltfBuffers(GltfSource& source, const GltfContainer& container, GltfFiles& files, const LoadOptions& options);

    [[nodiscard]] std::string_view bytes(std::size_t buffer) const { return bytes_[buffer]; }

private:
    std::vector<std::string_view> bytes_;
    std::vector<std::unique_ptr<std::string>> owned_;                     ///< decoded from data: URIs
    std::map<std::filesystem::path, std::unique_ptr<std::string>> files_; ///< each read once
};

} // namespace shadowlab::scene
