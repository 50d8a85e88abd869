// SPDX-License-Identifier: MIT
#include "app/report/part_file.h"

#include "app/picture/limits.h"
#include "techniques/foundation/base/error.h"
#include "techniques/foundation/scene/load/file_access.h"

namespace shadowlab::report {

std::string partBytes(const std::filesystem::path& file) {
    if (const std::string why = scene::whyUnreadable(file); !why.empty())
        throw Error(ExitStatus::badInput, file.string() + ": " + why + "; look at its permissions, or delete it");
    const scene::Limits& limits = picture::limits();
    return file.extension() == ".png" ? scene::readFile(file, limits.imageFileBytes, "image-file")
                                      : scene::readFile(file, limits.sceneFileBytes, "scene-file");
}

bool isText(const std::string& bytes) { return bytes.find('\0') == std::string::npos; }

} // namespace shadowlab::report
